/// All commands; each is defined in the file of its name.
#pragma once
#include "demos/commands/command.h"

namespace demos {

Command renderCommand();
Command joinCommand();
Command farmCommand();
Command planCommand();
Command stillCommand();
Command stripCommand();
Command simCommand();
Command plotCommand();
Command compareCommand();
Command sweepCommand();
Command exportCommand();
Command slidesCommand();
Command watchCommand();
Command galleryCommand();
Command siteCommand();
Command testCommand();
Command approveCommand();
Command listCommand();
Command doctorCommand();
Command benchCommand();

}  // namespace demos
