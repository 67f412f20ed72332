import type { Configuration, SeriesChoice } from './Configuration';
import { isNamed, type LabCase, type LabPlan, type LabSeries, plainCase } from './LabPlan';
import { lightKindNames, lightKinds, shadingNames, shadings } from './lightKinds';
import { presets } from './presets';
import { axisLabel, sceneWords } from './sceneWords';

/** Maximum number of WebGL contexts that the Lab keeps: browsers lose the oldest beyond 16, on phones beyond 8. */
export const MOST_CONTEXTS = { desktop: 15, phone: 6 };

/** Time to open and close a competitor for a case, and for frames after changes, on an average desktop (ms). */
const OPEN = 350;
const CHANGES = 150;

/**
 * Makes the cases of a configuration.
 *
 * @throws Error that names a scene, an axis, a kind of lights or values that are unknown or out of bounds
 */
export function planOf(configuration: Configuration): LabPlan {
  const { preset, competitors, effort } = configuration;
  if (competitors.length === 0) throw new Error('Nothing would be measured: choose at least one competitor.');
  const names = new Map<string, number>();
  const series = configuration.series.map((choice) => {
    const made = seriesOf(choice, configuration);
    const again = names.get(made.name) ?? 0;
    names.set(made.name, again + 1);
    return again === 0 ? made : { ...made, name: `${made.name}-${again + 1}` };
  });
  const label = presets[preset]?.label ?? 'Custom';
  return { preset, label, series, competitors, effort };
}

/** Estimated duration of a plan on an average desktop (ms); a slow competitor or device takes longer. */
export function estimate({ series, competitors, effort }: LabPlan): number {
  const cases = series.reduce((sum, { cases }) => sum + cases.length, 0);
  const each = OPEN + effort.rounds * effort.turn + (effort.changes ? CHANGES : 0);
  const whole = cases * competitors.length * each;
  return effort.limit === null ? whole : Math.min(whole, effort.limit);
}

function seriesOf(choice: SeriesChoice, size: { width: number; height: number }): LabSeries {
  const { scene, axis } = choice;
  const words = Object.hasOwn(sceneWords, scene) ? sceneWords[scene] : null;
  if (!words) throw new Error(`Unknown scene ${scene}: choose one of ${Object.keys(sceneWords).join(', ')}.`);
  if (!words.axes.includes(axis)) {
    throw new Error(`${words.label} cannot be measured over ${axis}: its axes are ${words.axes.join(', ')}.`);
  }
  const made = [...choice.values].sort((a, b) => a - b).map((value) => caseOf(choice, size, value));
  if (made.length === 0) throw new Error(`${words.label}: give at least one value, as in 10, 100, 1000.`);
  const cases = made.map((each) => each.labCase);
  const fixed = axis === 'lights' || scene === 'own' ? '' : `, ${lightsText(choice)}`;
  const planes = scene === 'benchmarkLights' && axis !== 'objects' ? ` ${choice.n} × ${choice.n}` : '';
  const along = axisLabel({ axis, cases }).toLowerCase();
  const label = `${words.label}${planes}${matterText(choice)} over ${along}${fixed}`;
  const parts = [scene === 'benchmarkLights' ? 'planes' : scene, axis];
  if (axis !== 'kind' && cases[0].lightKind !== 'points') parts.push(cases[0].lightKind);
  if (axis !== 'shading' && cases[0].shading !== 'own') parts.push(cases[0].shading);
  return { name: parts.join('-'), label, axis, cases, values: made.map((each) => each.value) };
}

/** Light kind, range and shading of all cases unless these are the defaults: ` (a LightField; reach 1 m)`. */
function matterText({ axis, lightKind = 'points', lightRange = null, shading = 'own' }: SeriesChoice): string {
  const kind = axis === 'kind' || lightKind === 'points' ? '' : lightKinds[lightKind].word;
  const reach = lightRange === null ? '' : `reach ${lightRange} m`;
  const shaded = axis === 'shading' || shading === 'own' ? '' : shadings[shading].word;
  const parts = [kind, reach, shaded].filter(Boolean);
  return parts.length === 0 ? '' : ` (${parts.join('; ')})`;
}

function lightsText({ lights }: SeriesChoice): string {
  return lights === 'objects' ? 'as many lights as planes' : `${lights} lights`;
}

/** A case and its value along the axis: planes and their lights are rounded to squares, pixels to the aspect ratio. */
function caseOf(choice: SeriesChoice, size: { width: number; height: number }, value: number) {
  const { scene, axis } = choice;
  checkMatter(choice, value);
  if (!Number.isFinite(value) || value < 0 || value > 1e6) {
    throw new Error(`${value} is not a value for ${axis}: give numbers from 0 to 1,000,000.`);
  }
  const square = scene === 'benchmarkLights';
  const side = (count: number, least: number): number => Math.max(least, Math.round(Math.sqrt(count)));
  const n = axis === 'objects' ? Math.min(100, side(value, 1)) : choice.n;
  const asked = axis === 'lights' ? value : choice.lights === 'objects' ? n * n : choice.lights;
  const lights = square ? side(asked, asked === 0 ? 0 : 1) ** 2 : Math.round(asked);
  const scale = axis === 'pixels' ? Math.sqrt((value * 1000) / (size.width * size.height)) : 1;
  const width = Math.max(1, Math.round(size.width * scale));
  const height = Math.max(1, Math.round(size.height * scale));
  if (width > 8192 || height > 8192) throw new Error(`${width} × ${height} pixels are too many: 8192 a side at most.`);
  const labCase: LabCase = {
    scene: { name: scene, parameters: square ? { n } : {} },
    lights: scene === 'own' ? null : lights,
    shadows: axis === 'shadows' ? Math.min(Math.round(value), lights) : 0,
    lightKind: axis === 'kind' ? lightKindNames[value] : (choice.lightKind ?? plainCase.lightKind),
    lightRange: choice.lightRange ?? null,
    shading: axis === 'shading' ? shadingNames[value] : (choice.shading ?? plainCase.shading),
    overdraw: axis === 'overdraw' ? Math.round(value) : 0,
    width,
    height,
  };
  const along = {
    lights,
    objects: n * n,
    pixels: width * height,
    overdraw: labCase.overdraw,
    shadows: labCase.shadows,
    kind: value,
    shading: value,
  };
  return { labCase, value: along[axis] };
}

/** Checks light kind, range and shading. @throws Error naming the one that is impossible */
function checkMatter(
  { scene, axis, lightKind = 'points', lightRange = null, shading = 'own' }: SeriesChoice,
  value: number,
) {
  if (isNamed(axis)) {
    const names = axis === 'kind' ? lightKindNames : shadingNames;
    if (names[value] === undefined) throw new Error(`${value} is not a ${axis}: choose one of ${names.join(', ')}.`);
  }
  if (!lightKindNames.includes(lightKind)) {
    throw new Error(`There are no lights of the kind ${lightKind}: choose one of ${lightKindNames.join(', ')}.`);
  }
  if (!shadingNames.includes(shading)) {
    throw new Error(`There is no shading ${shading}: choose one of ${shadingNames.join(', ')}.`);
  }
  if (lightRange !== null && !(lightRange >= 0.1 && lightRange <= 100)) {
    throw new Error(`Lights cannot reach ${lightRange} m: give 0.1 to 100 m.`);
  }
  if (scene === 'own' && (lightKind !== 'points' || lightRange !== null)) {
    throw new Error('A scene that was handed over has lights of its own: leave their kind and reach as they are.');
  }
  if (axis === 'shadows' && lightKind !== 'points') {
    throw new Error('Shadows are measured only with point lights: choose these, or another axis.');
  }
}
