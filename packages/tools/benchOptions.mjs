import { parseArgs } from 'node:util';

export const benchHelp = `npm run bench -- [options]

Draws scene × technique × lights × size in Chromium, in turns, and writes bench.md and bench.json.

  --scenes a,b        scenes of the viewer; default all. Parameters follow a colon: benchmarkLights:n=15,sponza
  --techniques a,b    default all of the registry
  --lights 10,100     numbers of moving lights; default 10,100,1000
  --size 1280x720     of the picture in pixels; several with commas
  --rounds 3          how often the whole matrix is measured
  --frames 60         timed frames of each kind in a case, at most
  --budget 2500       time for each kind of timed frames (ms); at least 3 frames are timed
  --timeout 60        for one case (s); one that fails is not tried again in a later round
  --minutes 0         start no case after this long; 0 for no limit
  --gpu               leave the flags of the software rasteriser out
  --only-counts       draws, programs and bytes, no times
  --dist DIR          a built viewer in place of building this one (then only playwright-core must be installed)
  --against REF       measure another build in turns with this one: a git ref, or a folder with a built viewer
  --build-only        build, put the viewers into OUT/now and OUT/against, and measure nothing
  --out DIR           default bench-results
  --help              this text

The browser is CHROMIUM_PATH, or the one that npm test finds. Figures are medians of the rounds' medians; p95 is over the
frames of all rounds.`;

/**
 * @typedef {{ name: string, parameters: Record<string, string> }} SceneChoice
 * @typedef {{ width: number, height: number }} Size pixels
 *
 * @typedef {object} BenchOptions
 * @property {SceneChoice[] | null} scenes null for all
 * @property {string[] | null} techniques null for all
 * @property {number[]} lights
 * @property {Size[]} sizes
 * @property {number} rounds
 * @property {number} frames
 * @property {number} budget ms
 * @property {number} timeout s
 * @property {number} minutes 0 for no limit
 * @property {boolean} gpu
 * @property {boolean} onlyCounts
 * @property {boolean} buildOnly
 * @property {string | null} dist
 * @property {string | null} against
 * @property {string} out
 * @property {boolean} help
 */

/**
 * Reads the command line.
 *
 * @param {string[]} args
 * @returns {BenchOptions}
 * @throws {Error} that names the option, its value and what is allowed
 */
export function parseBenchOptions(args) {
  const { values } = parseArgs({
    args,
    options: {
      scenes: { type: 'string' },
      techniques: { type: 'string' },
      lights: { type: 'string', default: '10,100,1000' },
      size: { type: 'string', default: '1280x720' },
      rounds: { type: 'string', default: '3' },
      frames: { type: 'string', default: '60' },
      budget: { type: 'string', default: '2500' },
      timeout: { type: 'string', default: '60' },
      minutes: { type: 'string', default: '0' },
      gpu: { type: 'boolean', default: false },
      'only-counts': { type: 'boolean', default: false },
      'build-only': { type: 'boolean', default: false },
      dist: { type: 'string' },
      against: { type: 'string' },
      out: { type: 'string', default: 'bench-results' },
      help: { type: 'boolean', default: false },
    },
  });
  if (values['build-only'] && values.dist !== undefined) {
    throw new Error('--build-only makes a build and --dist names one: give one of the two.');
  }
  return {
    scenes: values.scenes === undefined ? null : list('scenes', values.scenes).map(sceneChoice),
    techniques: values.techniques === undefined ? null : list('techniques', values.techniques),
    lights: list('lights', values.lights).map((text) => number('lights', text, { min: 0, integer: true })),
    sizes: list('size', values.size).map(size),
    rounds: number('rounds', values.rounds, { min: 1, integer: true }),
    frames: number('frames', values.frames, { min: 1, integer: true }),
    budget: number('budget', values.budget, { min: 1 }),
    timeout: number('timeout', values.timeout, { min: 1 }),
    minutes: number('minutes', values.minutes, { min: 0 }),
    gpu: values.gpu,
    onlyCounts: values['only-counts'],
    buildOnly: values['build-only'],
    dist: values.dist ?? null,
    against: values.against ?? null,
    out: values.out,
    help: values.help,
  };
}

/** @param {string} option @param {string} text */
function list(option, text) {
  const parts = text.split(',').map((part) => part.trim());
  if (parts.includes('')) throw new Error(`--${option} ${text}: names or numbers with commas between are needed.`);
  return [...new Set(parts)];
}

/** @param {string} option @param {string} text @param {{ min: number, integer?: boolean }} range */
function number(option, text, { min, integer = false }) {
  const value = text.trim() === '' ? Number.NaN : Number(text);
  if (Number.isFinite(value) && value >= min && (!integer || Number.isInteger(value))) return value;
  throw new Error(`--${option} ${text}: a ${integer ? 'whole ' : ''}number of ${min} or more is needed.`);
}

/** @param {string} text @returns {Size} */
function size(text) {
  const parts = /^(\d+)[x×](\d+)$/.exec(text);
  const [width, height] = parts ? [Number(parts[1]), Number(parts[2])] : [0, 0];
  if (width < 1 || height < 1 || width > 8192 || height > 8192) {
    throw new Error(`--size ${text}: width x height from 1x1 to 8192x8192 is needed, as in 1280x720.`);
  }
  return { width, height };
}

/** @param {string} text @returns {SceneChoice} */
function sceneChoice(text) {
  const [name, ...settings] = text.split(':');
  const entries = settings.map((setting) => {
    const at = setting.indexOf('=');
    if (at < 1) throw new Error(`--scenes ${text}: parameters are name=value with colons between.`);
    return [setting.slice(0, at), setting.slice(at + 1)];
  });
  return { name, parameters: Object.fromEntries(entries) };
}
