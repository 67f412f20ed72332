import { type Camera, type PerspectiveCamera, type Texture, Vector4 } from 'three';
import type { AtlasTile } from '../../frame/AtlasTiles';
import type { Frame } from '../../frame/Frame';
import { comparesDepths } from '../../gpu/comparesDepths';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import { isDepthReversed } from '../../three/state';
import type { BufferView, ShownView } from './BufferView';
import { Panels } from './Panels';
import { problems } from './problems';

/** Labels of tiles, by kind. */
const TILES: Record<AtlasTile['kind'], { readonly label: string }> = {
  map: { label: 'Shadow map, {near} to {far} m' },
  face: { label: 'Shadow map, face {number} of {count}, {near} to {far} m' },
  cascade: { label: 'Shadow map, cascade {number} of {count}, {near} to {far} m' },
  image: { label: 'Image' },
  profile: { label: 'Photometric profile' },
};

/** Values of `farol_kind` in atlasView.glsl. */
const NOTHING = 0;
const DEPTHS = 1;
const COLOURS = 2;

/** Shows the atlas of shadow maps, or of images and profiles of lights, as a square in the middle. */
export class AtlasView implements BufferView {
  private readonly panels = new Panels();
  private readonly pass = new FullscreenPass({
    program: 'atlas view',
    fragment: 'atlasView',
    asThree: true,
    repeats: true,
    uniforms: {
      farol_atlas: { value: null as Texture | null },
      farol_region: { value: new Vector4() },
      farol_panel: { value: this.panels.panel },
      farol_depths: { value: new Vector4() },
      farol_kind: { value: NOTHING },
    },
  });

  /** @param images - whether images and profiles are shown; else shadow maps */
  constructor(private readonly images: boolean) {}

  show(frame: Frame, info: ShownView): string | null {
    const { images, panels, pass } = this;
    const atlas = frame.tileShadows?.listTiles(images);
    const texture = atlas?.texture ?? null;
    if (atlas === undefined || texture === null || atlas.tiles.length === 0)
      return images ? problems.imageAtlas : problems.shadowAtlas;
    const { uniforms } = pass;
    uniforms.farol_atlas.value = texture;
    const compares = atlas.holds === 'depths';
    if (compares) comparesDepths(frame.webgl, texture, false);
    frame.bindTarget();
    panels.begin();
    uniforms.farol_kind.value = NOTHING;
    panels.next(frame, 0, 0, 1, 1);
    pass.draw(frame);
    panels.begin();
    uniforms.farol_kind.value = images ? COLOURS : DEPTHS;
    // the square of the atlas in the middle of the view
    const { z: width, w: height } = frame.viewport;
    const side = Math.min(width, height);
    const scale = side / atlas.size;
    for (const { light, kind, index, count, region, camera } of atlas.tiles) {
      const x = (0.5 * (width - side) + region.x * scale) / width;
      const y = (0.5 * (height + side) - (region.y + region.height) * scale) / height;
      const tile = panels.next(frame, x, y, (region.width * scale) / width, (region.height * scale) / height);
      tile.label = TILES[kind].label;
      tile.number = index + 1;
      tile.count = count;
      tile.light = light;
      if (camera !== null) this.setDepths(camera, isDepthReversed(frame.webgl), tile);
      uniforms.farol_region.value.set(region.x, region.y, region.width, region.height);
      pass.draw(frame);
    }
    if (compares) comparesDepths(frame.webgl, texture, true);
    panels.end(frame, info);
    return null;
  }

  dispose(): void {
    this.pass.dispose();
    this.panels.dispose();
  }

  private setDepths(camera: Camera, reversed: boolean, tile: { near: number; far: number }): void {
    const { near, far, isPerspectiveCamera } = camera as PerspectiveCamera;
    tile.near = near;
    tile.far = far;
    this.pass.uniforms.farol_depths.value.set(near, far, isPerspectiveCamera ? 1 : 0, reversed ? 1 : 0);
  }
}
