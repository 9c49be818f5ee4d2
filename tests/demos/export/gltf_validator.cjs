// Runs the Khronos validator on .glb files: gltf_validator.cjs MODULE FILE... Prints up to five
// issues per file, of any kind; fails for errors and warnings.
const fs = require("fs");
const validator = require(process.argv[2]);

async function check(file) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)));
    const { numErrors, numWarnings, messages } = report.issues;
    for (const message of messages.slice(0, 5))
        console.log(`${file}: ${message.code}: ${message.message} (${message.pointer})`);
    return numErrors + numWarnings;
}

(async () => {
    let bad = 0;
    const files = process.argv.slice(3);
    for (const file of files) bad += await check(file);
    console.log(`${files.length} files, ${bad} errors and warnings, ${validator.version()}`);
    process.exit(bad === 0 && files.length > 0 ? 0 : 1);
})();
