import { parseArgs } from 'node:util';

export const benchHelp = `npm run bench -- [options]

Measures a preset of the Lab headless, by the Lab's own code, and writes bench.json (which the Lab opens), bench.md and a
drawing (SVG) of each chart. Prints a table of each case beside what apps/lab/reached.json says was reached.

  --preset NAME       regression (the default), thesis, quick, lights, objects, resolution, overdraw, shadows, matter,
                      changes. quick ends after 80 s, and is a smaller one without --gpu, unless options say more of it
  --link FRAGMENT     in place of --preset: what the Lab's "Copy link" gives, from its # on, in quotes
  --regret            in place of --preset: all presets by auto and the techniques that it could draw by, and what auto
                      loses; ends with 1 where that is more than 5% in a case, or 2% on average
  --techniques a,b    competitors: the techniques, auto, lite, stock, multipass, three-webgpu, playcanvas, babylon
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
  --write             write the figures to apps/lab/reached.json
  --gpu               leave the flags of the software rasteriser out
  --dist DIR          a built Lab in place of building this one (then only playwright-core must be installed)
  --against REF       measure another build of Farol in turns with this one: a git ref that has a Lab, or a folder with a
                      built Lab; its competitors end in @against. Ends with 1 where this build is slower, twice: on the
                      GPU by more than 2%, on the CPU by more than 5%
  --build-only        build, put the Labs into OUT/now and OUT/against, and measure nothing
  --out DIR           default bench-results
  --help              this text

The browser is CHROMIUM_PATH, or the one that npm test finds. Figures are medians of the rounds' medians.`;

/** @typedef {ReturnType<typeof parseBenchOptions>} BenchOptions */

const text = /** @type {const} */ ({ type: 'string' });
const flag = /** @type {const} */ ({ type: 'boolean', default: false });

/** All options as `parseArgs` takes them. */
export const optionTypes = {
  ...{ preset: text, link: text, techniques: text, lights: text, size: text, rounds: text, turn: text, timeout: text },
  ...{ minutes: text, name: text, reference: text, dist: text, against: text, out: text },
  ...{ gpu: flag, rivals: flag, resume: flag, regret: flag, write: flag, help: flag },
  ...{ 'build-only': flag, 'without-pictures': flag },
};

/**
 * Reads the command line.
 *
 * @param {string[]} args
 * @throws {Error} that names the option, its value and what is allowed
 */
export function parseBenchOptions(args) {
  const { values } = parseArgs({ args, options: optionTypes });
  if (values['build-only'] && values.dist !== undefined) {
    throw new Error('--build-only makes a build and --dist names one: give one of the two.');
  }
  if ([values.preset, values.link, values.regret || undefined].filter((value) => value !== undefined).length > 1) {
    throw new Error('--preset, --link and --regret all say what to measure: give one of them.');
  }
  const { reference = null, regret, rivals, write, gpu, help } = values;
  if (reference !== null && !/^[a-z0-9-]+$/.test(reference)) {
    throw new Error(`--reference ${reference}: small letters, digits and hyphens are needed, as in h200-thesis.`);
  }
  const isReference = reference !== null;
  return {
    fragment: fragmentOf({ preset: isReference || regret ? 'thesis' : 'regression', ...values }),
    lights: values.lights === undefined ? null : lightsOf(values.lights),
    timeout: number('timeout', values.timeout ?? '300', { min: 1 }),
    minutes: number('minutes', values.minutes ?? '0', { min: 0 }),
    resume: values.resume || isReference,
    name: values.name ?? null,
    withoutPictures: values['without-pictures'] || isReference,
    reference,
    ...{ regret, rivals, write, gpu, help },
    dist: values.dist ?? null,
    against: values.against ?? null,
    buildOnly: values['build-only'],
    out: values.out ?? (isReference ? `.cache/reference/${reference}` : 'bench-results'),
  };
}

/**
 * Fragment of the Lab's address: the preset or link, and the other options of the command line.
 *
 * @param {{ preset: string, link?: string, techniques?: string, size?: string, rounds?: string, turn?: string }} values
 */
function fragmentOf({ preset, link, techniques, size: asked, rounds, turn }) {
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

/** @param {string} text */
function size(text) {
  const parts = /^(\d+)[x×](\d+)$/.exec(text);
  const [width, height] = parts ? [Number(parts[1]), Number(parts[2])] : [0, 0];
  if (width < 1 || height < 1 || width > 8192 || height > 8192) {
    throw new Error(`--size ${text}: width x height from 1x1 to 8192x8192 is needed, as in 1280x720.`);
  }
  return { width, height };
}
