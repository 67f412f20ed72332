import { FarolRenderer } from '@farol/renderer';
import { createWebGL } from '../competitors/createWebGL';
import { nextTask } from '../measure/nextTask';
import { waitForPixel } from '../measure/waitForPixel';
import { loseContext } from './loseContext';
import type { OwnedScene } from './StageScenes';

/** Number of frames, more than learning takes: 15 trials, one in 64 frames. */
const FRAMES = 1080;
/** Number of frames without a trial after which `auto` is considered sure of its choice. */
const SURE = 192;

/**
 * Draws a case by `auto`, which measures the techniques that it is unsure about, and stores results in `localStorage`.
 * @param scene - disposed at the end
 * @param onShare - called with the share of the frames that are drawn, 0 to 1
 */
export async function learnCase(scene: OwnedScene, signal: AbortSignal, onShare: (share: number) => void) {
  await FarolRenderer.preload();
  const canvas = document.createElement('canvas');
  Object.assign(canvas, { width: scene.width, height: scene.height });
  const { renderer, gl, check, dispose } = createWebGL(canvas, scene);
  const farol = new FarolRenderer(renderer, { technique: 'auto', learning: true });
  let hesitates = false;
  try {
    for (let frame = 0; frame < FRAMES && !signal.aborted && (hesitates || frame < SURE); frame++) {
      scene.setTime(frame / 60);
      farol.render(scene.three, scene.camera);
      hesitates ||= farol.info.reason.startsWith('measured against');
      waitForPixel(gl);
      await nextTask(); // GPU times arrive between tasks
      if (frame % 32 === 0) onShare(frame / FRAMES);
    }
    check();
  } finally {
    farol.dispose();
    dispose();
    scene.dispose();
    loseContext(gl);
  }
}
