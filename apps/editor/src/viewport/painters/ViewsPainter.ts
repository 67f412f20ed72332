import { type FarolRenderer, type View, views } from '@farol/renderer';
import { type Camera, Color, type Scene, Vector4 } from 'three';
import type { Painter } from '../Painter';
import type { Viewport } from '../Viewport';
import { gridCells } from './gridCells';

/**
 * Views in the grid: those available in every frame, since the grid is drawn without effects. The final image is drawn
 * last, so that the frame's statistics are those of a normal frame.
 */
export const gridViews: readonly View[] = views.slice(0, views.indexOf('grid'));

const whole = new Vector4();
const clear = new Color();

/** Shows all debug views of `gridViews` in a grid. */
export class ViewsPainter implements Painter {
  readonly drawsHelpers = false;
  readonly isGrid = true;
  private readonly farol: FarolRenderer;

  /** Checks that the device can draw all views. @throws Error naming the missing feature of the device */
  constructor(private readonly viewport: Viewport) {
    this.farol = viewport.farol;
    const { view } = this.farol;
    for (const each of gridViews) this.farol.view = each;
    this.farol.view = view;
  }

  render(scene: Scene, camera: Camera): void {
    const { farol } = this;
    const { webgl } = farol;
    const { width, height } = this.viewport.size;
    const { view } = farol;
    webgl.getViewport(whole);
    webgl.getClearColor(clear);
    const alpha = webgl.getClearAlpha();
    webgl.setClearColor(0x0b0d11, 1);
    webgl.clear();
    webgl.setClearColor(clear, alpha);
    const cells = gridCells(gridViews.length, width, height);
    webgl.setScissorTest(true);
    for (let i = cells.length - 1; i >= 0; i--) {
      const cell = cells[i];
      // WebGL measures y from the lower edge
      const bottom = height - cell.y - cell.height;
      webgl.setViewport(cell.x, bottom, cell.width, cell.height);
      webgl.setScissor(cell.x, bottom, cell.width, cell.height);
      farol.view = gridViews[i];
      farol.render(scene, camera);
    }
    farol.view = view;
    webgl.setScissorTest(false);
    webgl.setViewport(whole);
  }

  dispose(): void {}
}
