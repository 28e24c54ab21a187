// Holds GLB files against glTF 2.0 with Khronos's validator (gltf-validator of npm, found by NODE_PATH).
//   node gltf_validator.js FILE...
// Prints what it says and ends with 1 where that is more than nothing; 77: there is no validator.
const fs = require('fs');
let validator;
try {
  validator = require('gltf-validator');
} catch (error) {
  console.log('gltf-validator is not installed; `npm install gltf-validator` in the source folder');
  process.exit(77);
}
(async () => {
  for (const file of process.argv.slice(2)) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)));
    for (const message of report.issues.messages) console.log(file, JSON.stringify(message));
    const {numErrors, numWarnings, numInfos} = report.issues;
    if (numErrors + numWarnings + numInfos > 0) process.exitCode = 1;
  }
})();
