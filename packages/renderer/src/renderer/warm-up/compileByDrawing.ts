import { type Camera, type Object3D, type WebGLRenderer, WebGLRenderTarget } from 'three';
import { Lazy } from '../../frame/Lazy';
import { setDrawnAsCanvas } from '../../three/drawnAsCanvas';
import { programsOf } from '../../three/WaitingPrograms';

const load = (parts: Iterable<Lazy<object>>): Promise<unknown> => Promise.all(Array.from(parts, (part) => part.load()));

/** Finder of a scene's lights, as a frame uses it. */
interface LightSearch {
  find(scene: Object3D, camera: Camera, lightLayers: boolean): void;
}

/** Parts of a FarolRenderer that {@link compileByDrawing} uses. */
export interface Compiled {
  readonly webgl: WebGLRenderer;
  readonly techniques: Readonly<Record<string, { readonly lazy?: Lazy<object> }>>;
  readonly technique: string;
  readonly lightLayers: boolean;
  render(scene: Object3D, camera: Camera): void;
}

/**
 * Fetches the code that a frame of the scene needs, draws one pixel, which starts the compilation of the scene's programs, then
 * waits until the device has linked them.
 *
 * @param last - last frame of `farol`, with the code that it lacked
 * @throws Error when code cannot be fetched
 */
export async function compileByDrawing(
  farol: Compiled,
  { lacking }: { readonly lacking: ReadonlySet<Lazy<object>> },
  finder: LightSearch,
  scene: Object3D,
  camera: Camera,
): Promise<void> {
  const outer = Lazy.lacking;
  const asked = (Lazy.lacking = new Set());
  // lights need most of the late code; a frame without it would compile programs that are not used
  finder.find(scene, camera, farol.lightLayers);
  Lazy.lacking = outer;
  await Promise.all([load(asked), farol.techniques[farol.technique].lazy?.load()]);
  drawOnePixel(farol, scene, camera);
  while (lacking.size > 0 && !farol.webgl.getContext().isContextLost()) {
    await load(lacking);
    drawOnePixel(farol, scene, camera);
  }
  while (!programsOf(farol.webgl).every((program) => program.isReady())) {
    await new Promise((resolve) => setTimeout(resolve, 4));
  }
}

/** Draws a scene to a target of one pixel, with the programs that the current target needs. */
export function drawOnePixel(farol: Pick<Compiled, 'webgl' | 'render'>, scene: Object3D, camera: Camera): void {
  const { webgl } = farol;
  const before = webgl.getRenderTarget();
  const face = webgl.getActiveCubeFace();
  const level = webgl.getActiveMipmapLevel();
  const target = new WebGLRenderTarget(1, 1);
  if (before === null) {
    setDrawnAsCanvas(target, true);
    target.texture.colorSpace = webgl.outputColorSpace;
  }
  webgl.setRenderTarget(target);
  try {
    farol.render(scene, camera);
  } finally {
    webgl.setRenderTarget(before, face, level);
    target.dispose();
  }
}
