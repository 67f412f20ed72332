import { isTyping } from '@farol/editing';
import { KeyController } from '@farol/engine';
import type { Viewer } from '../Viewer';

/** Lets the user move the camera while time is stopped: each movement draws a frame, since no loop runs. */
export class StoppedFlight {
  private readonly held = new Set<string>();
  private request = 0;
  private last = 0;

  constructor(private readonly viewer: Viewer) {
    viewer.app.canvas.addEventListener('pointermove', (event) => {
      if (event.buttons !== 0) this.viewer.redraw();
    });
    addEventListener('keydown', (event) => {
      if (this.viewer.state.time === null || isTyping(event)) return;
      this.held.add(event.code);
      if (this.request === 0) {
        this.last = performance.now();
        this.request = requestAnimationFrame(this.frame);
      }
    });
    addEventListener('keyup', ({ code, key }) => {
      this.held.delete(code);
      // macOS sends no keyup for keys released while Command is held
      if (key === 'Meta') this.held.clear();
    });
    addEventListener('blur', () => this.held.clear());
  }

  private readonly frame = (now: number): void => {
    this.request = 0;
    const { state, app } = this.viewer;
    if (this.held.size === 0 || state.time === null) return;
    app.scene.activeCamera?.gameObject.getComponent(KeyController)?.update(Math.max(0, now - this.last) / 1000);
    this.viewer.redraw();
    this.last = now;
    this.request = requestAnimationFrame(this.frame);
  };
}
