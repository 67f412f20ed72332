import {
  AlwaysDepth,
  BasicShadowMap,
  DepthTexture,
  GreaterEqualCompare,
  HalfFloatType,
  type IUniform,
  LessEqualCompare,
  LinearFilter,
  NearestFilter,
  NoBlending,
  OrthographicCamera,
  type RenderTarget,
  RGFormat,
  type Texture,
  UnsignedIntType,
  Vector4,
  VSMShadowMap,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import type { MicroShaderRegistry } from '../../../microshaders';
import { FullscreenMesh } from '../../../gpu/FullscreenMesh';
import { PassMaterial } from '../../../gpu/PassMaterial';
import { comparesDepths } from '../atlas/comparesDepths';
import type { Draw } from './ShadowMapDraws';
import type { ShadowSlot } from '../slots/ShadowSlot';
import type { TileAtlas } from '../atlas/TileAtlas';

const rectangle = new Vector4();
const camera = new OrthographicCamera(); // where depth is reversed, three updates its projection
const WHITE = [1, 1, 1, 1];
const BLACK = [0, 0, 0, 0];

/** What is known of a light's `shadow.map`: no property of it, which a host could see change. */
interface Shown {
  readonly type: number;
  /** Its texture was asked for. */
  isWanted: boolean;
  /** It holds a copy. */
  isFilled: boolean;
}

const shown = new WeakMap<RenderTarget, Shown>();

/**
 * Notes from now on when the texture of a map is asked for, by three's ShadowMapViewer or by stock three. A map that three made
 * stays the object that it is: others may hold it.
 */
function watch(map: RenderTarget, type: number): Shown {
  const state = { type, isWanted: false, isFilled: false };
  shown.set(map, state);
  Object.defineProperty(map, 'texture', {
    configurable: true,
    get() {
      state.isWanted = true;
      return map.textures[0];
    },
    set(texture: Texture) {
      map.textures[0] = texture;
    },
  });
  return state;
}

/** Leaves a map as three makes them. */
function unwatch(map: RenderTarget): void {
  shown.delete(map);
  delete (map as Partial<RenderTarget>).texture;
}

/** Whether a map that three made is one of a type of shadow map. */
function isOfType({ textures, depthTexture, width, height }: RenderTarget, type: number): boolean {
  if (depthTexture === null || width * height === 0) return false;
  if (type === VSMShadowMap) return textures[0].format === RGFormat;
  return textures[0].format !== RGFormat && (depthTexture.compareFunction !== null) === (type !== BasicShadowMap);
}

/** One texel in which nothing casts a shadow. */
function makeMap(type: number, reversed: boolean): WebGLRenderTarget {
  const moments = type === VSMShadowMap;
  const depthTexture = new DepthTexture(1, 1, UnsignedIntType);
  const compares = !moments && type !== BasicShadowMap;
  depthTexture.compareFunction = compares ? (reversed ? GreaterEqualCompare : LessEqualCompare) : null;
  depthTexture.minFilter = depthTexture.magFilter = compares ? LinearFilter : NearestFilter;
  return new WebGLRenderTarget(1, 1, {
    depthTexture,
    ...(moments && { format: RGFormat, type: HalfFloatType, minFilter: LinearFilter, magFilter: LinearFilter }),
  });
}

function disposeMap(map: RenderTarget): void {
  map.depthTexture?.dispose();
  map.dispose();
}

/**
 * Keeps `light.shadow.map` of spot and directional lights as three's own addons expect it: one texel in which nothing casts a
 * shadow, or what three has drawn, until its texture is asked for, and then a copy of the light's part of the atlas. Point
 * lights have none.
 */
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
    if (isCube) return false;
    const state = shadow.map === null ? undefined : shown.get(shadow.map);
    if (state === undefined || state.type !== type) return isDrawn;
    return state.isWanted && (isDrawn || !state.isFilled);
  }

  /** Whether all of a light's map is to be drawn. */
  isWatched({ shadow }: ShadowSlot): boolean {
    return shadow.map !== null && shown.get(shadow.map)?.isWanted === true;
  }

  /** Gives a light its map, and copies it where that is asked for. Call inside three's `render`, once the maps are drawn. */
  render(slot: ShadowSlot, atlas: TileAtlas, type: number): void {
    const { shadow } = slot;
    const reversed = this.webgl.state.buffers.depth.getReversed();
    let { map } = shadow;
    let state = map === null ? undefined : shown.get(map);
    if (map === null || (state === undefined ? !isOfType(map, type) : state.type !== type)) {
      if (map !== null) disposeMap(map);
      map = shadow.map = makeMap(type, reversed);
      this.clear(map, reversed);
      state = undefined;
    }
    if (state === undefined) {
      state = watch(map, type);
      this.made.add(slot);
    }
    if (!state.isWanted) return;
    this.copy(slot, map, atlas, reversed);
    state.isFilled = true;
  }

  /** The light has no tile any more. */
  release(slot: ShadowSlot): void {
    const { map } = slot.shadow;
    if (!this.made.delete(slot) || map === null || !shown.has(map)) return;
    unwatch(map);
    disposeMap(map);
    slot.shadow.map = null;
  }

  dispose(): void {
    for (const slot of this.made) this.release(slot);
    this.depths?.dispose();
    this.moments?.dispose();
    this.depths = this.moments = null;
  }

  private clear(map: RenderTarget, reversed: boolean): void {
    const { webgl } = this;
    const gl = webgl.getContext() as WebGL2RenderingContext;
    webgl.setRenderTarget(map as WebGLRenderTarget);
    webgl.state.buffers.color.setMask(true);
    webgl.state.buffers.depth.setTest(true);
    webgl.state.buffers.depth.setMask(true);
    gl.clearBufferfv(gl.COLOR, 0, reversed ? BLACK : WHITE);
    gl.clearBufferfv(gl.DEPTH, 0, [reversed ? 0 : 1]);
  }

  private copy(slot: ShadowSlot, map: RenderTarget, atlas: TileAtlas, reversed: boolean): void {
    const { webgl, uniforms } = this;
    const { maxTextureSize } = webgl.capabilities;
    const width = Math.min(slot.wantedWidth, maxTextureSize);
    const height = Math.min(slot.wantedHeight, maxTextureSize);
    const face = slot.faces[slot.faces.length - 1];
    const moments = map.textures[0].format === RGFormat;
    const material = moments ? (this.moments ??= this.make('moments')) : (this.depths ??= this.make('depths'));
    if (map.width !== width || map.height !== height) map.setSize(width, height);
    uniforms.farol_shownAtlas.value = atlas.texture;
    uniforms.farol_shownTile.value.set(face.x, face.y, face.width / width, face.height / height);
    uniforms.farol_shownFar.value = reversed ? 0 : 1;
    material.uniformsNeedUpdate = true;
    if (!moments) comparesDepths(webgl, atlas.texture!, false);
    webgl.setRenderTarget(map as WebGLRenderTarget);
    webgl.state.viewport(rectangle.set(0, 0, width, height));
    (webgl.renderBufferDirect as unknown as Draw)(camera, null, this.triangle.geometry, material, this.triangle, null);
    if (!moments) comparesDepths(webgl, atlas.texture!, true);
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
