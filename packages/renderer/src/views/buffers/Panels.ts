import { Vector4 } from 'three';
import type { Frame } from '../../frame/Frame';
import type { ViewTile } from '../../frame/ViewInfo';
import { setViewport } from '../../three/state';
import type { ShownView } from './BufferView';

/** Panels in which a view draws its parts one by one; their `ViewTile` objects are reused from frame to frame. */
export class Panels {
  readonly tiles: ViewTile[] = [];
  /** Rectangle of the panel to draw (pixels of the target). */
  readonly panel = new Vector4();
  private readonly kept: ViewTile[] = [];

  begin(): void {
    this.tiles.length = 0;
  }

  /**
   * Adds a panel, and sets the viewport of the next draws to it.
   * @param x - left edge, as a share of the viewport; y, width and height likewise, y from above
   */
  next(frame: Frame, x: number, y: number, width: number, height: number): ViewTile {
    const { kept, panel, tiles } = this;
    const { viewport } = frame;
    const left = Math.round(x * viewport.z);
    const bottom = Math.round((1 - y - height) * viewport.w);
    const right = Math.round((x + width) * viewport.z);
    const top = Math.round((1 - y) * viewport.w);
    panel.set(viewport.x + left, viewport.y + bottom, Math.max(1, right - left), Math.max(1, top - bottom));
    setViewport(frame.webgl, panel);
    const tile = (kept[tiles.length] ??= {
      ...{ x: 0, y: 0, width: 0, height: 0, label: '', number: 1, count: 1, near: 0, far: 0, light: null },
    });
    tile.x = x;
    tile.y = y;
    tile.width = width;
    tile.height = height;
    tile.number = tile.count = 1;
    tile.near = tile.far = 0;
    tile.light = null;
    tiles.push(tile);
    return tile;
  }

  /** Restores the whole viewport, and lists the drawn tiles in `info`. */
  end({ webgl, viewport }: Frame, info: ShownView): void {
    setViewport(webgl, viewport);
    info.tiles = this.tiles;
  }

  dispose(): void {
    this.tiles.length = this.kept.length = 0;
  }
}
