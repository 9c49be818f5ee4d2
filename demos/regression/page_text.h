/// The report's page: page/report.html with its style and script, built in; its data come between.
#pragma once
#include <string>

namespace demos {

std::string pageTextBeforeData();
std::string pageTextAfterData();

}  // namespace demos
