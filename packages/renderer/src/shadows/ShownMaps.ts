import {
  AlwaysDepth,
  BasicShadowMap,
  Camera,
  DepthTexture,
  GreaterEqualCompare,
  HalfFloatType,
  type IUniform,
  LessEqualCompare,
  LinearFilter,
  NearestFilter,
  NoBlending,
  RGFormat,
  type Texture,
  UnsignedIntType,
  Vector4,
  VSMShadowMap,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import type { MicroShaderRegistry } from '../microshaders';
import { FullscreenMesh } from '../passes/FullscreenMesh';
import { PassMaterial } from '../passes/PassMaterial';
import { comparesDepths } from './comparesDepths';
import type { Draw } from './ShadowMapDraws';
import type { ShadowSlot } from './ShadowSlot';
import type { TileAtlas } from './TileAtlas';

const rectangle = new Vector4();
const camera = new Camera();
const WHITE = [1, 1, 1, 1];
const BLACK = [0, 0, 0, 0];

/** Maps whose texture was asked for, and those that hold a copy: no properties, which a host could see change. */
const wanted = new WeakSet<ShownMap>();
const filled = new WeakSet<ShownMap>();

/**
 * What `light.shadow.map` is of a light whose map lies in the atlas: one texel in which nothing casts a shadow, until its texture
 * is asked for (by three's ShadowMapViewer, or by stock three), and then a copy of the map.
 */
export class ShownMap extends WebGLRenderTarget {
  constructor(
    readonly mapType: number,
    reversed: boolean,
  ) {
    const moments = mapType === VSMShadowMap;
    const depthTexture = new DepthTexture(1, 1, UnsignedIntType);
    const compares = !moments && mapType !== BasicShadowMap;
    depthTexture.compareFunction = compares ? (reversed ? GreaterEqualCompare : LessEqualCompare) : null;
    depthTexture.minFilter = depthTexture.magFilter = compares ? LinearFilter : NearestFilter;
    super(1, 1, {
      depthTexture,
      ...(moments && { format: RGFormat, type: HalfFloatType, minFilter: LinearFilter, magFilter: LinearFilter }),
    });
    this.isWanted = false;
  }

  /** Its texture was asked for. */
  get isWanted(): boolean {
    return wanted.has(this);
  }

  set isWanted(is: boolean) {
    if (is) wanted.add(this);
    else wanted.delete(this);
  }

  /** It holds a copy. */
  get isFilled(): boolean {
    return filled.has(this);
  }

  set isFilled(is: boolean) {
    if (is) filled.add(this);
    else filled.delete(this);
  }

  override get texture(): Texture {
    this.isWanted = true;
    return this.textures[0];
  }

  override set texture(texture: Texture) {
    this.textures[0] = texture;
  }

  override dispose(): void {
    this.isFilled = false;
    this.depthTexture?.dispose();
    super.dispose();
  }
}

/** Keeps `light.shadow.map` of spot and directional lights as three's own addons expect it. Point lights have none. */
export class ShownMaps {
  private readonly triangle = new FullscreenMesh();
  private readonly uniforms = {
    farol_shownAtlas: { value: null } as IUniform<Texture | null>,
    farol_shownTile: { value: new Vector4() },
    farol_shownFar: { value: 1 },
  };
  private readonly made = new Set<ShadowSlot>();
  private depths: PassMaterial | null = null;
  private moments: PassMaterial | null = null;

  constructor(
    private readonly webgl: WebGLRenderer,
    private readonly microshaders: MicroShaderRegistry,
  ) {}

  /** Whether a light's map is to be copied in this frame. @param isDrawn it is drawn anew */
  wants({ shadow, isCube }: ShadowSlot, isDrawn: boolean, type: number): boolean {
    const { map } = shadow;
    if (isCube) return false;
    if (!(map instanceof ShownMap) || map.mapType !== type) return isDrawn;
    return map.isWanted && (isDrawn || !map.isFilled);
  }

  /** Whether all of a light's map is to be drawn. */
  isWatched({ shadow }: ShadowSlot): boolean {
    return shadow.map instanceof ShownMap && shadow.map.isWanted;
  }

  /** Gives a light its map, and copies it where that is asked for. Call inside three's `render`, once the maps are drawn. */
  render(slot: ShadowSlot, atlas: TileAtlas, type: number): void {
    const { webgl } = this;
    const { shadow } = slot;
    const reversed = webgl.state.buffers.depth.getReversed();
    let map = shadow.map as ShownMap | null;
    if (!(map instanceof ShownMap) || map.mapType !== type) {
      map?.dispose();
      map = shadow.map = new ShownMap(type, reversed);
      this.made.add(slot);
      this.clear(map, reversed);
      map.isWanted = false;
    }
    if (map.isWanted) this.copy(slot, map, atlas, reversed);
  }

  /** The light has no tile any more. */
  release(slot: ShadowSlot): void {
    const { map } = slot.shadow;
    if (!this.made.delete(slot) || !(map instanceof ShownMap)) return;
    map.dispose();
    slot.shadow.map = null;
  }

  dispose(): void {
    for (const slot of this.made) this.release(slot);
    this.depths?.dispose();
    this.moments?.dispose();
    this.depths = this.moments = null;
  }

  private clear(map: ShownMap, reversed: boolean): void {
    const { webgl } = this;
    const gl = webgl.getContext() as WebGL2RenderingContext;
    webgl.setRenderTarget(map);
    webgl.state.buffers.color.setMask(true);
    webgl.state.buffers.depth.setTest(true);
    webgl.state.buffers.depth.setMask(true);
    gl.clearBufferfv(gl.COLOR, 0, reversed ? BLACK : WHITE);
    gl.clearBufferfv(gl.DEPTH, 0, [reversed ? 0 : 1]);
  }

  private copy(slot: ShadowSlot, map: ShownMap, atlas: TileAtlas, reversed: boolean): void {
    const { webgl, uniforms } = this;
    const { maxTextureSize } = webgl.capabilities;
    const width = Math.min(slot.wantedWidth, maxTextureSize);
    const height = Math.min(slot.wantedHeight, maxTextureSize);
    const face = slot.faces[slot.faces.length - 1];
    const moments = map.mapType === VSMShadowMap;
    const material = moments ? (this.moments ??= this.make('moments')) : (this.depths ??= this.make('depths'));
    if (map.width !== width || map.height !== height) map.setSize(width, height);
    uniforms.farol_shownAtlas.value = atlas.texture;
    uniforms.farol_shownTile.value.set(face.x, face.y, face.width / width, face.height / height);
    uniforms.farol_shownFar.value = reversed ? 0 : 1;
    material.uniformsNeedUpdate = true;
    if (!moments) comparesDepths(webgl, atlas.texture!, false);
    webgl.setRenderTarget(map);
    webgl.state.viewport(rectangle.set(0, 0, width, height));
    (webgl.renderBufferDirect as unknown as Draw)(camera, null, this.triangle.geometry, material, this.triangle, null);
    if (!moments) comparesDepths(webgl, atlas.texture!, true);
    map.isFilled = true;
  }

  private make(name: string): PassMaterial {
    return new PassMaterial(this.microshaders, {
      name: `Farol shown ${name}`,
      vertex: ['fullscreen'],
      fragment: ['shownMap'],
      uniforms: this.uniforms,
      defines: name === 'moments' ? { FAROL_MOMENTS: '' } : {},
      blending: NoBlending,
      depthTest: true,
      depthWrite: true,
      depthFunc: AlwaysDepth,
    });
  }
}
