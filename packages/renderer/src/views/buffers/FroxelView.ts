import type { Data3DTexture } from 'three';
import type { Frame } from '../../frame/Frame';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import type { BufferView, ShownView } from './BufferView';
import { Panels } from './Panels';
import { problems } from './problems';

/** Name of a slice. */
const SLICE = { label: 'Slice {number} of {count}, {near} to {far} m' } as const;

/** Shows the light in all slices of froxels, from the eye (upper left) to the end of the fog (lower right). */
export class FroxelView implements BufferView {
  private readonly panels = new Panels();
  private readonly pass = new FullscreenPass({
    program: 'froxel view',
    fragment: 'froxelView',
    asThree: true,
    toneMapped: true,
    repeats: true,
    uniforms: {
      farol_froxels: { value: null as Data3DTexture | null },
      farol_panel: { value: this.panels.panel },
      farol_slice: { value: 0 },
    },
  });

  show(frame: Frame, info: ShownView): string | null {
    const buffer = frame.resources.find('froxels');
    if (buffer === undefined) return problems.fog;
    const { panels, pass } = this;
    const slices = buffer.froxels[2];
    const columns = Math.ceil(Math.sqrt(slices));
    const rows = Math.ceil(slices / columns);
    pass.uniforms.farol_froxels.value = buffer.scattered;
    frame.bindTarget();
    panels.begin();
    for (let i = 0; i < columns * rows; i++) {
      const [x, y] = [(i % columns) / columns, Math.floor(i / columns) / rows];
      const tile = panels.next(frame, x, y, 1 / columns, 1 / rows);
      tile.label = SLICE.label;
      tile.number = Math.min(i, slices - 1) + 1;
      tile.count = slices;
      tile.near = buffer.depthOf(tile.number - 1);
      tile.far = buffer.depthOf(tile.number);
      // beyond the last slice, texelFetch returns black
      pass.uniforms.farol_slice.value = i;
      pass.draw(frame);
    }
    panels.tiles.length = slices;
    panels.end(frame, info);
    return null;
  }

  dispose(): void {
    this.pass.dispose();
    this.panels.dispose();
  }
}
