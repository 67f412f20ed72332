import { PerspectiveCamera } from 'three';
import type { App } from '../App';
import type { XRStage } from './playInXR';

/** Stage of an App: its scene, which goes on advancing if the App was running and playing. */
export function stageOf(app: App): XRStage {
  const { picture, running } = app;
  return {
    picture,
    get scene() {
      return app.scene;
    },
    get camera() {
      return app.scene.activeCamera?.three ?? new PerspectiveCamera();
    },
    advance: (seconds) => running && app.playing && app.scene.update(seconds),
    pause: () => app.stop(),
    resume: () => running && app.start(),
  };
}
