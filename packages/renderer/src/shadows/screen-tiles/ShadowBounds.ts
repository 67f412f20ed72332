import {
  type IUniform,
  NoBlending,
  RGIntegerFormat,
  type Texture,
  UnsignedShortType,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import { wordTarget } from '../../gpu/wordTarget';
import { comparesDepths } from '../../gpu/comparesDepths';
import type { RegionDrawer } from '../draw/RegionDrawer';
import type { ShadowSlot } from '../slots/ShadowSlot';
import type { TextureAtlas } from '../atlas/TextureAtlas';

/**
 * Side of a block of shadow-map texels whose depths are bounded; shadowBounds.glsl and tileShadows.glsl repeat the
 * number.
 */
const BLOCK = 8;
/** Number of frames without a change after which minimum and maximum depths of a shadow map are computed. */
const REST = 2;
/** Number of shadow-map texels whose depths are bounded in a frame; the map that exceeds it is the frame's last. */
const BUDGET = 12_000_000;

/**
 * Smallest and largest depth of each block of 8 × 8 texels of the atlas of depths, for unchanged maps. A block at a map's edge
 * includes texels of its neighbours, so bounds may be too wide, never too narrow.
 */
export class ShadowBounds {
  readonly target: WebGLRenderTarget = wordTarget(RGIntegerFormat, UnsignedShortType, 'RG16UI');
  private readonly depths: IUniform<Texture | null> = { value: null };
  private readonly pass = new FullscreenPass({
    program: 'shadow bounds',
    fragment: 'shadowBounds',
    uniforms: { farol_shadowDepths: this.depths },
    blending: NoBlending,
  });
  private isCompiled = false;
  private readonly unboundedSlots: ShadowSlot[] = [];
  private left = BUDGET;

  constructor(
    private readonly webgl: WebGLRenderer,
    private readonly drawer: RegionDrawer,
  ) {}

  get bytes(): number {
    return this.target.width * this.target.height * 4;
  }

  /** True when the frame has maps whose depths are to be bounded. */
  get hasWork(): boolean {
    return this.unboundedSlots.length > 0;
  }

  begin(): void {
    this.unboundedSlots.length = 0;
    this.left = BUDGET;
  }

  /** Adds a map that the frame does not draw. @param rested - number of frames since the map last changed */
  keep(slot: ShadowSlot, rested: number): void {
    if (slot.map.hasBounds || rested < REST || slot.cascades > 0 || this.left <= 0) return;
    const { region } = slot.placement;
    this.left -= region!.width * region!.height;
    this.unboundedSlots.push(slot);
  }

  /** Finds the bounds of the maps that `keep` added. Call once the maps of the frame are drawn. */
  render(atlas: TextureAtlas): void {
    const { webgl, target } = this;
    if (!this.isCompiled) this.compile();
    if (!this.hasWork) return;
    const blocks = Math.ceil(atlas.target!.width / BLOCK);
    if (target.width !== blocks) target.setSize(blocks, blocks);
    const texture = atlas.target!.depthTexture!;
    this.depths.value = texture;
    comparesDepths(webgl, texture, false);
    this.drawer.bind(target);
    for (const slot of this.unboundedSlots) {
      this.draw(slot);
      slot.map.bound();
    }
    comparesDepths(webgl, texture, true);
  }

  dispose(): void {
    this.target.dispose();
    this.pass.dispose();
    this.isCompiled = false;
  }

  /** Compiles the program with the first map, so that no later frame hitches. */
  private compile(): void {
    this.isCompiled = true;
    this.drawer.bind(this.target);
    this.pass.compile(this.drawer);
  }

  private draw({ placement }: ShadowSlot): void {
    const { x, y, width, height } = placement.region!;
    const left = Math.floor(x / BLOCK);
    const bottom = Math.floor(y / BLOCK);
    const right = Math.ceil((x + width) / BLOCK);
    const top = Math.ceil((y + height) / BLOCK);
    this.drawer.drawPart(this.pass, left, bottom, right - left, top - bottom);
  }
}
