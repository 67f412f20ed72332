import { DataUtils, type Scene, type WebGLRenderer } from 'three';
import { AppliedBake } from './apply/AppliedBake';
import { freeChannel } from './apply/litGeometry';
import type { Bake, BakedLightmap, BakedMesh } from './Bake';
import type { BakeOptions } from './BakeOptions';
import { type CheckedBakeOptions, checkBakeOptions } from './checkOptions';
import { keepState } from './gpu/keepState';
import { Slices } from './gpu/Slices';
import { untilLoss } from './gpu/untilLoss';
import { LightmapTracer } from './lightmap/LightmapTracer';
import { Surfaces } from './lightmap/Surfaces';
import { measurePhase } from './measurePhase';
import type { BakedProbes } from './probes/BakedProbes';
import { Progress } from './Progress';
import { restoreBake } from './restoreBake';
import { type CollectedLights, collectLights } from './scene/collectLights';
import { collectMeshes } from './scene/collectMeshes';
import { mergeTriangles } from './scene/mergeTriangles';
import { lightTable } from './trace/lightTable';
import { skySource } from './trace/SkySource';
import { stitchSeams } from './seams/stitchSeams';
import { TracedScene } from './trace/TracedScene';
import { unwrapReflectors } from './unwrap/unwrapReflectors';
import { unwrapStaticMeshes } from './unwrap/unwrapStaticMeshes';

/**
 * Bakes the light of a scene into lightmaps, while the page stays responsive. Apply the result with {@link Bake.apply}.
 * The scene is not changed, except while `showProgress` applies intermediate results; do not change it during the bake.
 *
 * @param renderer - its WebGL context traces the paths
 * @throws RangeError for an option out of range; Error when the scene has nothing to bake, or the device cannot bake
 */
export async function bakeLightmaps(renderer: WebGLRenderer, scene: Scene, options: BakeOptions = {}): Promise<Bake> {
  const checked = checkBakeOptions(options);
  checked.signal?.throwIfAborted();
  checkDevice(renderer);
  const { signal, end } = untilLoss(renderer, checked.signal);
  try {
    return await bake(renderer, scene, { ...checked, signal });
  } finally {
    end();
  }
}

async function bake(renderer: WebGLRenderer, scene: Scene, checked: CheckedBakeOptions): Promise<Bake> {
  const { signal, onWarning } = checked;
  const progress = new Progress(checked.onProgress);
  scene.updateMatrixWorld(true);
  const lights = collectLights(scene, checked.isBaked, onWarning);
  const collected = collectMeshes(scene, checked);
  const kept = collected.filter(({ isReflecting }) => !isReflecting);
  if (!kept.some(({ isLit }) => isLit)) {
    throw new Error('There is nothing to bake: give a static mesh a lit material.');
  }
  let begin = performance.now();
  const layout = await unwrapStaticMeshes(kept, checked, (share) => progress.report('unwrapping', share));
  const count = layout.texelsPerMetre.length;
  const reflectors = await unwrapReflectors(
    collected.filter(({ isReflecting }) => isReflecting),
    Math.min(...layout.texelsPerMetre),
    count,
    checked,
  );
  const meshes = [...kept, ...reflectors.meshes];
  const unwrapped = [...layout.unwrapped, ...reflectors.unwrapped];
  const texelsPerMetre = [...layout.texelsPerMetre, ...reflectors.texelsPerMetre];
  measurePhase('unwrap', begin);
  signal?.throwIfAborted();
  progress.report('preparing', 0);
  const baked = kept.flatMap(({ mesh }, i): BakedMesh[] => {
    const own = layout.unwrapped[i];
    return own ? [{ mesh, ...own }] : [];
  });
  const channel = freeChannel(baked.map(({ mesh }) => mesh.geometry));
  const skyOf = checked.sky === 'environment' ? scene : null;
  begin = performance.now();
  const triangles = mergeTriangles(meshes, unwrapped);
  measurePhase('merge', begin);
  const gone = [...lights.traced, ...lights.skies].flatMap(({ light, isIndirect }) => (isIndirect ? [] : [light]));

  const traced = keepState(renderer, () => new TracedScene(renderer, triangles));
  const surfaces = new Surfaces(renderer, triangles, checked.size);
  const tracer = new LightmapTracer(renderer, surfaces, traced, {
    ...checked,
    texelsPerMetre,
    hasProbes: checked.probes !== undefined,
    onSlice: (share, samples) => progress.report('tracing', share, samples),
  });
  for (const picture of tracer.pictures) picture.channel = channel;
  const shown = checked.showProgress ? new AppliedBake(baked, gone, tracer.pictures, channel, skyOf) : null;
  try {
    shown?.apply();
    const { lightmaps, probes } = await trace(renderer, scene, tracer, traced, lights, count, checked, progress);
    progress.report('finishing', 0.3);
    begin = performance.now();
    if (checked.stitch) await stitchSeams(lightmaps, layout, checked);
    measurePhase('stitch', begin);
    const size = { width: checked.size, height: checked.size };
    const halves = lightmaps.map((floats): BakedLightmap => ({ ...size, data: Uint16Array.from(floats, toHalf) }));
    progress.report('finishing', 1);
    return restoreBake({ lightmaps: halves, meshes: baked, channel, probes }, { lights: gone, skyOf });
  } finally {
    shown?.dispose();
    tracer.dispose();
    surfaces.dispose();
    traced.dispose();
  }
}

/** Converts irradiance to a half float; too large values are clamped to the largest finite half float. */
const toHalf = (value: number): number => DataUtils.toHalfFloat(Math.min(value, 65504));

/** @param count - number of lightmaps in the result */
async function trace(
  renderer: WebGLRenderer,
  scene: Scene,
  tracer: LightmapTracer,
  traced: TracedScene,
  lights: CollectedLights,
  count: number,
  { sky, sliceMilliseconds, signal, onWarning, probes: points }: CheckedBakeOptions,
  progress: Progress,
): Promise<{ lightmaps: Float32Array[]; probes: BakedProbes | null }> {
  const table = (isIndirect: boolean) =>
    lightTable(
      lights.traced.filter((light) => light.isIndirect === isIndirect),
      traced.bounds,
    );
  const skies = (isIndirect: boolean) =>
    skySource(
      scene,
      isIndirect ? 'none' : sky,
      lights.skies.filter((each) => each.isIndirect === isIndirect),
      onWarning,
    );
  const tables = [table(false), table(true)] as const;
  try {
    const slices = new Slices(renderer, sliceMilliseconds, signal);
    progress.report('tracing', 0);
    const sources = [skies(false), skies(true)] as const;
    await tracer.run(tables, sources, slices);
    let begin = performance.now();
    const probes = points ? await tracer.readProbes(points, tables[0], sources[0], slices) : null;
    if (points) measurePhase('probes', begin);
    progress.report('finishing', 0);
    begin = performance.now();
    const lightmaps: Float32Array[] = [];
    for (let i = 0; i < count; i++) {
      lightmaps.push(await tracer.read(i));
      signal?.throwIfAborted();
    }
    measurePhase('read', begin);
    return { lightmaps, probes };
  } finally {
    for (const each of tables) each.dispose();
  }
}

/** @throws Error for a device that cannot bake, and while the context is lost, as its abilities are unknown then */
export function checkDevice(renderer: WebGLRenderer): void {
  if (renderer.getContext().isContextLost())
    throw new Error('The bake cannot begin: the WebGL context is lost. Bake again once the picture is back.');
  const missing = ['EXT_color_buffer_float', 'EXT_float_blend'].filter((name) => !renderer.extensions.has(name));
  if (missing.length === 0) return;
  throw new Error(
    `This device cannot bake: its WebGL2 has no ${missing.join(' and no ')}. Use another browser or device.`,
  );
}
