import {
  type IUniform,
  NoBlending,
  PerspectiveCamera,
  RGIntegerFormat,
  type Texture,
  UnsignedShortType,
  Vector4,
  type WebGLRenderer,
} from 'three';
import type { MicroShaderRegistry } from '../../../microshaders';
import { FullscreenMesh } from '../../../gpu/FullscreenMesh';
import { PassMaterial } from '../../../gpu/PassMaterial';
import { wordTarget } from '../../../gpu/wordTarget';
import { comparesDepths } from '../atlas/comparesDepths';
import type { Draw } from '../draw/ShadowMapDraws';
import type { ShadowSlot } from '../slots/ShadowSlot';
import type { TileAtlas } from '../atlas/TileAtlas';

/** Texels a side of a block, as in shadowBounds.glsl. */
const BLOCK = 8;
/** Frames for which a map has to be at rest. */
const REST = 2;
/** Texels of maps looked at a frame at most, but for one map. */
const BUDGET = 12_000_000;

const rectangle = new Vector4();
const camera = new PerspectiveCamera();

/**
 * Least and greatest depth of each block of 8 × 8 texels of the atlas, for maps that are at rest. A block at the edge of a map
 * may count in what lies beside it, older texels too: bounds may be wider than need be, never narrower.
 */
export class ShadowBounds {
  readonly target = wordTarget(RGIntegerFormat, UnsignedShortType, 'RG16UI');
  private readonly triangle = new FullscreenMesh();
  private readonly depths: IUniform<Texture | null> = { value: null };
  private material: PassMaterial | null = null;
  private readonly wanted: ShadowSlot[] = [];
  private left = BUDGET;

  constructor(
    private readonly webgl: WebGLRenderer,
    private readonly microshaders: MicroShaderRegistry,
  ) {}

  get bytes(): number {
    return this.target.width * this.target.height * 4;
  }

  /** True when the frame has some to find. */
  get hasWork(): boolean {
    return this.wanted.length > 0;
  }

  begin(): void {
    this.wanted.length = 0;
    this.left = BUDGET;
  }

  /** A map that is lit with as it is. @param rested frames since something changed in it */
  keep(slot: ShadowSlot, rested: number): void {
    if (slot.isBounded || rested < REST || slot.cascades > 0 || this.left <= 0) return;
    this.left -= slot.tile!.width * slot.tile!.height;
    this.wanted.push(slot);
  }

  /** Finds those of the maps that were kept. Call once the maps of the frame are drawn. */
  render(atlas: TileAtlas): void {
    const { webgl, target } = this;
    if (this.material === null) this.compile();
    if (!this.hasWork) return;
    const blocks = Math.ceil(atlas.target!.width / BLOCK);
    if (target.width !== blocks) target.setSize(blocks, blocks);
    const texture = atlas.target!.depthTexture!;
    this.depths.value = texture;
    comparesDepths(webgl, texture, false);
    webgl.setRenderTarget(target);
    for (const slot of this.wanted) {
      this.draw(slot);
      slot.isBounded = true;
    }
    comparesDepths(webgl, texture, true);
  }

  dispose(): void {
    this.target.dispose();
    this.material?.dispose();
    this.material = null;
  }

  /** Has its program there from the first map on, not in a later frame. */
  private compile(): void {
    this.material = new PassMaterial(this.microshaders, {
      name: 'Farol shadow bounds',
      vertex: ['fullscreen'],
      fragment: ['shadowBounds'],
      uniforms: { farol_shadowDepths: this.depths },
      blending: NoBlending,
    });
    this.webgl.setRenderTarget(this.target);
    const { geometry } = this.triangle;
    geometry.setDrawRange(0, 0);
    this.drawTriangle();
    geometry.setDrawRange(0, 3);
  }

  private drawTriangle(): void {
    const draw = this.webgl.renderBufferDirect as unknown as Draw;
    draw(camera, null, this.triangle.geometry, this.material!, this.triangle, null);
  }

  private draw({ tile }: ShadowSlot): void {
    const { x, y, width, height } = tile!;
    const left = Math.floor(x / BLOCK);
    const bottom = Math.floor(y / BLOCK);
    const right = Math.ceil((x + width) / BLOCK);
    const top = Math.ceil((y + height) / BLOCK);
    this.webgl.state.viewport(rectangle.set(left, bottom, right - left, top - bottom));
    this.drawTriangle();
  }
}
