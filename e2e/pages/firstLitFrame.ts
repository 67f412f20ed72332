import { FarolRenderer } from '@farol/renderer';
import { scenes } from '@farol/scenes';
import * as three from 'three';

/** Milliseconds from the first call of `render` until the GPU has finished a picture. */
export interface FirstLitFrame {
  /** The first one: by a technique whose code is there, under all lights. */
  first: number;
  /** The first one that lacks no code. */
  whole: number;
  /** Frames until then. */
  frames: number;
  /** Techniques of the first frame and of that one; 'stock' for three itself. */
  techniques: string[];
}

/** Times the first frames of the atrium by a renderer that is made for it, whose code may be in the browser's cache. */
export async function timeFirstLitFrame(
  byFarol: boolean,
  lights: number,
  width: number,
  height: number,
): Promise<FirstLitFrame> {
  const made = await scenes.sponza.build({ lights });
  made.update(0);
  const scene = made.three as unknown as three.Scene;
  const camera = made.activeCamera!.three as unknown as three.PerspectiveCamera;
  camera.aspect = width / height;
  camera.updateProjectionMatrix();
  const webgl = new three.WebGLRenderer({ antialias: false });
  webgl.setSize(width, height, false);
  const gl = webgl.getContext();
  const finish = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  // the context itself is not what is timed
  webgl.clear();
  finish();
  const farol = byFarol ? new FarolRenderer(webgl) : null;
  const renderer = farol ?? webgl;
  const begin = performance.now();
  let frames = 0;
  const draw = (): number => {
    renderer.render(scene, camera);
    finish();
    frames++;
    return performance.now() - begin;
  };
  const technique = () => farol?.info.technique ?? 'stock';
  const first = draw();
  const techniques = [technique()];
  let whole = first;
  while ((farol?.info.pending.length ?? 0) > 0) {
    await new Promise(requestAnimationFrame);
    whole = draw();
  }
  techniques.push(technique());
  farol?.dispose();
  webgl.dispose();
  return { first, whole, frames, techniques };
}
