import { parseArgs } from 'node:util';

export const benchHelp = `npm run bench -- --preset NAME [options]

Measures a preset of the Lab headless, by the Lab's own code, and writes bench.json (which the Lab opens), bench.md and a
drawing (SVG) of each chart.

  --preset NAME       thesis, quick, lights, objects, resolution, overdraw, shadows, matter, changes. quick ends after
                      80 s, and is a smaller one without --gpu, unless options say more of it
  --link FRAGMENT     in place of --preset: what the Lab's "Copy link" gives, from its # on, in quotes
  --techniques a,b    competitors: the techniques, auto, stock, multipass, three-webgpu, playcanvas, babylon
  --rivals            the other engines too (npm run rivals installs them)
  --lights 10,100     in place of the preset's, for its series over lights
  --size 1280x720     of the picture in pixels; default the preset's
  --rounds 3          turns that each competitor gets; default the preset's
  --turn 400          length of a turn (ms); default the preset's
  --timeout 300       without a sign of the page for so long (s), the browser is started anew
  --minutes 0         end after this long, and keep what is there; 0 for no limit
  --resume            go on with the run of OUT/bench.json that ended early
  --name TEXT         the run's name
  --without-pictures  leave the thumbnails out of bench.json
  --reference NAME    for the repository: --resume, --without-pictures, the preset thesis unless another is given, OUT
                      .cache/reference/NAME, and apps/lab/reference/NAME.json once every case is measured
  --gpu               leave the flags of the software rasteriser out
  --dist DIR          a built Lab in place of building this one (then only playwright-core must be installed)
  --against REF       measure another build of Farol in turns with this one: a git ref that has a Lab, or a folder with a
                      built Lab; its competitors end in @against
  --build-only        build, put the Labs into OUT/now and OUT/against, and measure nothing
  --out DIR           default bench-results
  --help              this text

Without --preset and --link: npm run bench -- [options]

Draws scene × technique × lights × size in the viewer, in turns, and writes bench.md and bench.json.

  --scenes a,b        scenes of the viewer; default all. Parameters follow a colon: benchmarkLights:n=15,sponza
  --techniques a,b    default all of the registry
  --lights 10,100     numbers of moving lights; default 10,100,1000
  --size 1280x720     of the picture in pixels; several with commas
  --rounds 3          how often the whole matrix is measured
  --frames 60         timed frames of each kind in a case, at most
  --budget 2500       time for each kind of timed frames (ms); at least 3 frames are timed
  --timeout 60        for one case (s); one that fails is not tried again in a later round
  --minutes 0         start no case after this long; 0 for no limit
  --only-counts       draws, programs and bytes, no times
  --gpu, --dist, --against, --build-only, --out: as above, with the viewer in the Lab's place

The browser is CHROMIUM_PATH, or the one that npm test finds. Figures are medians of the rounds' medians; p95 is over the
frames of all rounds.`;

/**
 * @typedef {{ name: string, parameters: Record<string, string> }} SceneChoice
 * @typedef {{ width: number, height: number }} Size pixels
 *
 * @typedef {object} SharedOptions
 * @property {string[] | null} techniques null for all
 * @property {number} timeout s
 * @property {number} minutes 0 for no limit
 * @property {boolean} gpu
 * @property {boolean} buildOnly
 * @property {string | null} dist
 * @property {string | null} against
 * @property {string} out
 * @property {boolean} help
 *
 * @typedef {object} MatrixOptions
 * @property {'matrix'} mode
 * @property {SceneChoice[] | null} scenes null for all
 * @property {number[]} lights
 * @property {Size[]} sizes
 * @property {number} rounds
 * @property {number} frames
 * @property {number} budget ms
 * @property {boolean} onlyCounts
 *
 * @typedef {object} LabOptions null for what the preset says
 * @property {'lab'} mode
 * @property {string} fragment of the Lab's address
 * @property {number[] | null} lights
 * @property {boolean} rivals
 * @property {boolean} resume
 * @property {boolean} withoutPictures
 * @property {string | null} name
 * @property {string | null} reference
 *
 * @typedef {SharedOptions & MatrixOptions} MatrixBench
 * @typedef {SharedOptions & LabOptions} LabBench
 */

/** Options that one of the two ways of measuring alone knows, with what to do in the other. */
const ofMatrix = {
  scenes: 'choose a preset or give a --link that names series',
  frames: '--turn gives the time of each competitor',
  budget: '--turn gives the time of each competitor',
  'only-counts': 'bench.json has the counts too',
};
const ofLab = ['rivals', 'turn', 'resume', 'name', 'without-pictures'];

const text = /** @type {const} */ ({ type: 'string' });
const flag = /** @type {const} */ ({ type: 'boolean' });

/** All options as `parseArgs` takes them. */
export const optionTypes = {
  ...{ preset: text, link: text, scenes: text, techniques: text, lights: text, size: text, rounds: text, turn: text },
  ...{ frames: text, budget: text, timeout: text, minutes: text, name: text, reference: text, dist: text },
  ...{ against: text, out: text, gpu: flag, rivals: flag, resume: flag, help: flag },
  ...{ 'only-counts': flag, 'build-only': flag, 'without-pictures': flag },
};

/**
 * Reads the command line.
 *
 * @param {string[]} args
 * @returns {MatrixBench | LabBench}
 * @throws {Error} that names the option, its value and what is allowed
 */
export function parseBenchOptions(args) {
  const { values } = parseArgs({ args, options: optionTypes });
  if (values['build-only'] && values.dist !== undefined) {
    throw new Error('--build-only makes a build and --dist names one: give one of the two.');
  }
  if (values.preset !== undefined && values.link !== undefined) {
    throw new Error('--preset and --link both say what to measure: give one of the two.');
  }
  const shared = {
    techniques: values.techniques === undefined ? null : list('techniques', values.techniques),
    minutes: number('minutes', values.minutes ?? '0', { min: 0 }),
    gpu: values.gpu ?? false,
    buildOnly: values['build-only'] ?? false,
    dist: values.dist ?? null,
    against: values.against ?? null,
    help: values.help ?? false,
  };
  const given = /** @type {Record<string, unknown>} */ (values);
  if (values.preset === undefined && values.link === undefined && values.reference === undefined) {
    const wrong = ofLab.find((name) => given[name] !== undefined);
    if (wrong) throw new Error(`--${wrong} belongs to the Lab: give a --preset too.`);
    return {
      ...shared,
      mode: 'matrix',
      scenes: values.scenes === undefined ? null : list('scenes', values.scenes).map(sceneChoice),
      lights: lightsOf(values.lights ?? '10,100,1000'),
      sizes: list('size', values.size ?? '1280x720').map(size),
      rounds: number('rounds', values.rounds ?? '3', { min: 1, integer: true }),
      frames: number('frames', values.frames ?? '60', { min: 1, integer: true }),
      budget: number('budget', values.budget ?? '2500', { min: 1 }),
      timeout: number('timeout', values.timeout ?? '60', { min: 1 }),
      onlyCounts: values['only-counts'] ?? false,
      out: values.out ?? 'bench-results',
    };
  }
  for (const [name, instead] of Object.entries(ofMatrix)) {
    if (given[name] !== undefined)
      throw new Error(`--${name} belongs to the viewer's matrix: with a preset, ${instead}.`);
  }
  const { reference = null } = values;
  if (reference !== null && !/^[a-z0-9-]+$/.test(reference)) {
    throw new Error(`--reference ${reference}: small letters, digits and hyphens are needed, as in h200-thesis.`);
  }
  return {
    ...shared,
    mode: 'lab',
    fragment: fragmentOf(values),
    lights: values.lights === undefined ? null : lightsOf(values.lights),
    timeout: number('timeout', values.timeout ?? '300', { min: 1 }),
    rivals: values.rivals ?? false,
    resume: (values.resume ?? false) || reference !== null,
    withoutPictures: (values['without-pictures'] ?? false) || reference !== null,
    name: values.name ?? null,
    reference,
    out: values.out ?? (reference === null ? 'bench-results' : `.cache/reference/${reference}`),
  };
}

/**
 * Fragment of the Lab's address: the preset or link, and the other options of the command line.
 *
 * @param {{ preset?: string, link?: string, techniques?: string, size?: string, rounds?: string, turn?: string }} values
 */
function fragmentOf({ preset = 'thesis', link, techniques, size: asked, rounds, turn }) {
  const fragment = new URLSearchParams(link === undefined ? { preset } : link.replace(/^[^#]*#/, ''));
  if (techniques !== undefined) fragment.set('techniques', list('techniques', techniques).join(','));
  if (asked !== undefined) {
    const { width, height } = size(asked);
    fragment.set('size', `${width}x${height}`);
  }
  if (rounds !== undefined) fragment.set('rounds', String(number('rounds', rounds, { min: 1, integer: true })));
  if (turn !== undefined) fragment.set('turn', String(number('turn', turn, { min: 10 })));
  return fragment.toString();
}

/** @param {string} text */
const lightsOf = (text) => list('lights', text).map((each) => number('lights', each, { min: 0, integer: true }));

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
