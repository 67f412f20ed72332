import { type Camera, type Object3D, type WebGLRenderer, WebGLRenderTarget } from 'three';
import { programsOf } from '../../three/WaitingPrograms';

/** A FarolRenderer. */
interface Renderer {
  readonly webgl: WebGLRenderer;
  render(scene: Object3D, camera: Camera): void;
}

/** Draws one pixel, which starts the compilation of everything the scene needs, then waits until the device is done. */
export async function compileByDrawing(farol: Renderer, scene: Object3D, camera: Camera): Promise<void> {
  drawOnePixel(farol, scene, camera);
  while (!programsOf(farol.webgl).every((program) => program.isReady())) {
    await new Promise((resolve) => setTimeout(resolve, 4));
  }
}

/** Draws a scene to a target of one pixel. */
export function drawOnePixel(farol: Renderer, scene: Object3D, camera: Camera): void {
  const { webgl } = farol;
  const before = webgl.getRenderTarget();
  const face = webgl.getActiveCubeFace();
  const level = webgl.getActiveMipmapLevel();
  const target = new WebGLRenderTarget(1, 1);
  webgl.setRenderTarget(target);
  try {
    farol.render(scene, camera);
  } finally {
    webgl.setRenderTarget(before, face, level);
    target.dispose();
  }
}
