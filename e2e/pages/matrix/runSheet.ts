import type { FarolOptions, TechniqueName } from '@farol/renderer';
import { Group } from 'three';
import { atRelease, Bench } from '../Bench';
import type { Difference } from '../../support/images';
import type { Cases } from './Case';
import { gltfCases } from './gltfCases';
import { geometryCases } from './geometryCases';
import { mapCases } from './mapCases';
import { materialCases } from './materialCases';
import { orderCases } from './orderCases';
import { lightShaderCases, shaderCases } from './shaderCases';
import { CLEAR, Sheet, sheetSize } from './Sheet';

export const sheets = {
  materials: materialCases,
  maps: mapCases,
  geometry: geometryCases,
  order: orderCases,
  glTF: gltfCases,
  shaders: shaderCases,
  'shaders of lights': lightShaderCases,
} as const satisfies Record<string, Cases | (() => Promise<Cases>)>;

/** How far a technique's picture of one case is from stock three's. */
export interface CaseResult extends Difference {
  readonly sheet: string;
  readonly case: string;
  readonly technique: string;
}

export interface SheetResult {
  readonly results: CaseResult[];
  /** Cases that stock three does not show: they would test nothing. */
  readonly unseen: string[];
  /** All cases of the sheet, also those that are not drawn. */
  readonly known: string[];
}

/** Bench of all sheets of a test: programs that one compiled need not be compiled for the next. */
let sharedBench: Bench | null = null;

function makeBench(): Bench {
  const made = new Bench(1, 1, { target: { stencilBuffer: true } });
  made.webgl.localClippingEnabled = true;
  made.webgl.setClearColor(CLEAR.color, CLEAR.alpha);
  made.farol.inferredScale = 1;
  atRelease(() => (sharedBench = null));
  return made;
}

/** A sheet of cases, and the bench that all sheets share, sized for it. */
async function openSheet(name: keyof typeof sheets, every = 1) {
  const listed: Cases | (() => Promise<Cases>) = sheets[name];
  const all = typeof listed === 'function' ? await listed() : listed;
  const cases: Cases = Object.fromEntries(Object.entries(all).filter((_, index) => index % every === 0));
  const { width, height } = sheetSize(cases);
  const bench = (sharedBench ??= makeBench());
  bench.setSize(width, height);
  const kit = { environment: bench.environment() };
  return { bench, cases, kit, known: Object.keys(all), sheet: new Sheet(cases, kit) };
}

/**
 * Draws the cases of a sheet by stock three and by each technique.
 *
 * @param every - draws the first of each so many cases; default all
 */
export async function runSheet(
  name: keyof typeof sheets,
  techniques: readonly TechniqueName[],
  every = 1,
): Promise<SheetResult> {
  const { bench, cases, kit, known, sheet } = await openSheet(name, every);
  const empty = new Sheet(Object.fromEntries(Object.keys(cases).map((key) => [key, () => new Group()])), kit);
  const nothing = bench.stock(empty.scene, empty.camera);
  const stock = bench.stock(sheet.scene, sheet.camera);
  const unseen = sheet.compare(nothing, stock).filter(({ largest }) => largest === 0);
  const results = techniques.flatMap((technique) =>
    sheet
      .compare(stock, bench.byTechnique(technique, sheet.scene, sheet.camera))
      .map(({ name: key, ...difference }) => ({ sheet: name, case: key, technique, ...difference })),
  );
  return { results, unseen: unseen.map(({ name: key }) => key), known };
}

/** Draws all cases of a sheet by a technique with the quality 'lite', against 'full'. */
export async function compareQualities(name: keyof typeof sheets, technique: TechniqueName): Promise<CaseResult[]> {
  const { bench, sheet } = await openSheet(name);
  const [full, lite] = (['full', 'lite'] satisfies FarolOptions['quality'][]).map((quality) => {
    bench.farol.quality = quality;
    return bench.byTechnique(technique, sheet.scene, sheet.camera);
  });
  bench.farol.quality = 'auto';
  return sheet
    .compare(full, lite)
    .map(({ name: key, ...difference }) => ({ sheet: name, case: key, technique, ...difference }));
}
