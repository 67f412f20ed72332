import { PerspectiveCamera } from 'three';
import type { App } from '../App';
import type { XRStage } from './playInXR';

/** Stage of an App: its scene, advanced as far as the App was running and playing. */
export function stageOf(app: App): XRStage {
  const { scene, picture, running } = app;
  return {
    picture,
    scene,
    camera: scene.activeCamera?.three ?? new PerspectiveCamera(),
    advance: (seconds) => running && app.playing && scene.update(seconds),
    pause: () => app.stop(),
    resume: () => running && app.start(),
  };
}
