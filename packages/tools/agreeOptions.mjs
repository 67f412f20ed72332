export const agreeHelp = `npm run agree -- [options]

Draws the agreement suites by every technique against stock three, in linear float, and prints a table.

  --gpu             take the GPU of this machine, not the software rasteriser
  --workers N       browsers side by side; default the number of cores, at most 10
  --models DIR      compare the glTF models of a folder of yours; default those of three npm packages
  --no-models       leave the models out
  --chance N        draw N scenes made by chance in place of the suites; those that are off are cut down and named by kind
  --seed N          seed of the first scene by chance; default 0. One scene: --chance 1 --seed N
  --only TEXT       the tests whose title matches this regular expression
  --json FILE       write each comparison to FILE, a line of JSON each
  --pack DIR        put all that a host without a network needs into DIR, and run nothing
  --help            this text`;

/** Options in the form of util.parseArgs. */
export const agreeOptions = /** @type {const} */ ({
  gpu: { type: 'boolean' },
  workers: { type: 'string' },
  models: { type: 'string' },
  'no-models': { type: 'boolean' },
  chance: { type: 'string' },
  seed: { type: 'string' },
  only: { type: 'string' },
  json: { type: 'string' },
  pack: { type: 'string' },
  help: { type: 'boolean' },
});
