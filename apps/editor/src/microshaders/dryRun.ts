import { MicroShaderOverrides, type MicroShaderProblem } from '@farol/engine';
import { type FarolOptions, FarolRenderer } from '@farol/renderer';
import type { MicroShaderRegistry, Technique } from '@farol/renderer/authoring';
import { WebGLRenderer } from 'three';
import { type DrySource, makeDryContext } from './DryContext';
import { makeDryScene } from './dryScene';

/**
 * Sources of the shaders that a technique or debug view uses on this device, without drawing or compiling.
 * @param texts - microshaders of the scene
 * @param techniques - techniques by name, including ones that the renderer may not know
 * @param inspect - called with the registry that has the texts, and names of the texts that the registry refused
 */
export function dryRun(
  gl: WebGL2RenderingContext,
  { technique = 'auto', view }: Pick<FarolOptions, 'technique' | 'view'>,
  texts: ReadonlyMap<string, string>,
  techniques: Readonly<Record<string, Technique>> = {},
  inspect: (registry: MicroShaderRegistry, problems: readonly MicroShaderProblem[]) => void = () => {},
): readonly DrySource[] {
  const { context, sources } = makeDryContext(gl);
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 16;
  const webgl = new WebGLRenderer({ canvas, context });
  const farol = new FarolRenderer(webgl, { view });
  for (const [name, each] of Object.entries(techniques)) {
    if (!Object.hasOwn(farol.techniques, name)) farol.addTechnique(name, each);
  }
  farol.technique = technique;
  const { scene, camera, dispose } = makeDryScene();
  try {
    inspect(farol.microshaders, new MicroShaderOverrides(farol.microshaders).apply(texts));
    sources.length = 0;
    farol.render(scene, camera);
  } finally {
    farol.dispose();
    dispose();
    webgl.dispose();
  }
  return sources;
}

const FRAME = /^\/\/ <([^/>][^>]*)>/gm;

/** Names of the microshaders in a composed source, by their markers; without three's chunks. */
export function chunksOf(source: string): Set<string> {
  return new Set([...source.matchAll(FRAME)].map(([, name]) => name).filter((name) => !name.startsWith('three/')));
}
