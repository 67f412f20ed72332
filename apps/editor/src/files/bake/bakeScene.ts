import type { BakedProbes, BakeProgress, TraceOptions } from '@farol/bake';
import { type Scene, soloLights } from '@farol/engine';
import {
  type BakeData,
  type BakeMesh,
  bakeSignature,
  type BakeSources,
  bakeSources,
  dampRinging,
  fillBuriedProbes,
  isStaticWithoutLightmap,
  probeBox,
  type ProbeData,
} from '@farol/engine/bake';
import { type ProbeBox, probePoints } from '@farol/renderer/light-probes';
import type { Light as ThreeLight, Object3D, WebGLRenderer } from 'three';

type Baker = typeof import('@farol/bake');

export interface BakeSceneOptions {
  readonly signal: AbortSignal;
  progressed(progress: BakeProgress): void;
  /** Called with a sentence about each thing that is baked differently than expected. */
  warned(sentence: string): void;
}

/** Sets the sizes of three's lights that determine soft shadows. @returns a function that restores them */
function sizeLights({ lights }: BakeSources): () => void {
  for (const light of lights) {
    const { userData } = light.three;
    userData.farol = { ...userData.farol, radius: light.bakedRadius, angle: light.bakedAngle };
  }
  return () => {
    for (const light of lights) if (light.isAttached) light.applyFields();
  };
}

function traceOptions(scene: Scene, sources: BakeSources): TraceOptions {
  const { settings } = scene;
  const meshes = new Set<Object3D>(sources.meshes.map(({ mesh }) => mesh));
  const modes = new Map<ThreeLight, string>(sources.lights.map((light) => [light.three, light.mode]));
  return {
    bounces: settings.bakeBounces,
    samples: settings.bakeSamples,
    sky: settings.bakeSky && scene.three.environment ? 'environment' : 'none',
    isStatic: (object, instance) => meshes.has(object) || isStaticWithoutLightmap(object, instance),
    isBaked: (light) => (modes.get(light) === 'mixed' ? 'indirect' : modes.has(light)),
  };
}

function probesOf(box: ProbeBox, { coefficients, backFaces }: BakedProbes): ProbeData {
  const filled = new Float32Array(coefficients);
  fillBuriedProbes(box, filled, backFaces);
  dampRinging(filled);
  return { box, coefficients: filled };
}

/**
 * Bakes a scene by its settings. The scene must not use baked light meanwhile.
 * @throws Error (as a rejection) saying why it cannot be baked, or the reason of the signal
 */
export async function bakeScene(
  baker: Baker,
  webgl: WebGLRenderer,
  scene: Scene,
  { signal, progressed, warned }: BakeSceneOptions,
): Promise<BakeData> {
  scene.three.updateMatrixWorld(true);
  const sources = bakeSources(scene);
  const { settings } = scene;
  const signature = bakeSignature(scene, sources);
  // missing lightmaps are not reported: the panel counts instanced objects, and light probes light objects without one
  const onWarning = (sentence: string): void => void (/ gets no lightmap: /.test(sentence) || warned(sentence));
  const shared = { ...traceOptions(scene, sources), signal, onWarning };
  const endSizes = sizeLights(sources);
  const alone = soloLights(scene, null);
  try {
    const box = settings.bakeProbes ? probeBox(sources.meshes, settings.bakeProbeSpacing) : null;
    const bake = await baker.bakeLightmaps(webgl, scene.three, {
      ...shared,
      size: Number(settings.bakeSize),
      texelsPerMetre: settings.bakeTexelsPerMetre > 0 ? settings.bakeTexelsPerMetre : undefined,
      denoise: settings.bakeDenoise,
      stitch: settings.bakeStitch,
      probes: box ? probePoints(box) : undefined,
      onProgress: progressed,
    });
    const baked = new Map<Object3D, BakeMesh>(sources.meshes.map((each) => [each.mesh, each]));
    // restores the original geometries, which the lightmaps belong to
    bake.remove();
    const meshes = bake.meshes.flatMap(({ mesh, lightmap, uv1, index, sourceVertex }) => {
      const source = baked.get(mesh);
      if (!source) return [];
      return {
        component: source.component.id,
        part: source.part,
        lightmap,
        sourceVertices: mesh.geometry.getAttribute('position').count,
        uv1: new Float32Array(uv1),
        index: new Uint32Array(index),
        sourceVertex: new Uint32Array(sourceVertex),
      };
    });
    const lightmaps = bake.lightmaps.map(({ width, height, data }) => ({ width, height, data: new Uint16Array(data) }));
    bake.dispose();
    return {
      signature,
      lights: sources.lights.filter(({ mode }) => mode === 'baked').map(({ id }) => id),
      hasSky: shared.sky !== 'none',
      channel: bake.channel,
      lightmaps,
      meshes,
      probes: box && bake.probes ? probesOf(box, bake.probes) : null,
    };
  } finally {
    soloLights(scene, alone);
    endSizes();
  }
}
