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
  type RenderTarget,
  RGFormat,
  type Texture,
  UnsignedIntType,
  Vector4,
  VSMShadowMap,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import { comparesDepths } from '../../gpu/comparesDepths';
import type { RegionDrawer } from './RegionDrawer';
import type { ShadowSlot } from '../slots/ShadowSlot';
import type { TextureAtlas } from '../atlas/TextureAtlas';
import { isDepthReversed, unmaskColour, unmaskDepth } from '../../three/state';

const WHITE = [1, 1, 1, 1];
const BLACK = [0, 0, 0, 0];

/** Farol's state for a light's `shadow.map`; not a property of the map, where a host would see it. */
interface Watched {
  /** `shadowMap.type` for which the map was made. */
  readonly type: number;
  /** Whether the host has read the map's texture or depths. */
  isWanted: boolean;
  /** Whether the map holds a copy of the light's region of the atlas. */
  isFilled: boolean;
}

const watched = new WeakMap<RenderTarget, Watched>();

/**
 * Watches a map for reads of its texture or depths, by three's ShadowMapViewer, stock three or the host. The map stays the same
 * object, since others may hold it.
 */
function watch(map: RenderTarget, type: number): Watched {
  const state = { type, isWanted: false, isFilled: false };
  const { depthTexture } = map;
  watched.set(map, state);
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
  Object.defineProperty(map, 'depthTexture', {
    configurable: true,
    get() {
      state.isWanted = true;
      return depthTexture;
    },
    // three sets the property when it changes the map's type
    set(other: DepthTexture | null) {
      unwatch(map);
      map.depthTexture = other;
    },
  });
  return state;
}

/** Ends `watch`: the map's texture and depths are plain properties again, as three makes them. */
function unwatch(map: RenderTarget): void {
  watched.delete(map);
  delete (map as Partial<RenderTarget>).texture;
  delete (map as Partial<RenderTarget>).depthTexture;
}

/** Whether a map made by three is of a type (`shadowMap.type`). */
function isOfType({ textures, depthTexture, width, height }: RenderTarget, type: number): boolean {
  if (depthTexture === null || width * height === 0) return false;
  if (type === VSMShadowMap) return textures[0].format === RGFormat;
  return textures[0].format !== RGFormat && (depthTexture.compareFunction !== null) === (type !== BasicShadowMap);
}

/** Makes a shadow map of one texel; the caller clears it to a depth at which nothing is in shadow. */
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
 * Keeps `light.shadow.map` of spot and directional lights as three's addons expect it. Until its texture is read, it is one
 * texel without shadow, or the map that three itself has drawn; from then on a copy of the light's region of the atlas. Point
 * lights have none.
 */
export class HostShadowMaps {
  private readonly uniforms = {
    farol_hostMapAtlas: { value: null } as IUniform<Texture | null>,
    farol_hostMapRegion: { value: new Vector4() },
    farol_hostMapFar: { value: 1 },
    farol_hasMoments: { value: false },
  };
  /** Slots of the lights whose maps are watched. */
  private readonly slots = new Set<ShadowSlot>();
  private readonly pass = new FullscreenPass({
    program: 'host shadow map',
    fragment: 'hostShadowMap',
    uniforms: this.uniforms,
    repeats: true,
    blending: NoBlending,
    depthTest: true,
    depthWrite: true,
    depthFunc: AlwaysDepth,
  });

  constructor(
    private readonly webgl: WebGLRenderer,
    private readonly drawer: RegionDrawer,
  ) {}

  /** Bytes of the maps made here: colours or moments, and depths. */
  get bytes(): number {
    let texels = 0;
    for (const { shadow } of this.slots) if (shadow.map !== null) texels += shadow.map.width * shadow.map.height;
    return 8 * texels;
  }

  /** Whether a light's map is to be copied in this frame. @param isDrawn - whether the frame draws the map */
  wants({ shadow, isCube }: ShadowSlot, isDrawn: boolean, type: number): boolean {
    if (isCube) return false;
    const state = shadow.map === null ? undefined : watched.get(shadow.map);
    if (state === undefined || state.type !== type) return isDrawn;
    return state.isWanted && (isDrawn || !state.isFilled);
  }

  /** Whether a light's map is copied, so that all of it has to be drawn. */
  isWatched({ shadow }: ShadowSlot): boolean {
    return shadow.map !== null && watched.get(shadow.map)?.isWanted === true;
  }

  /** Gives a light its `shadow.map`, with a copy if it is read. Call inside three's `render`, once the maps are drawn. */
  render(slot: ShadowSlot, atlas: TextureAtlas, type: number): void {
    const { shadow } = slot;
    const reversed = isDepthReversed(this.webgl);
    let { map } = shadow;
    let state = map === null ? undefined : watched.get(map);
    if (map === null || (state === undefined ? !isOfType(map, type) : state.type !== type)) {
      if (map !== null) disposeMap(map);
      map = shadow.map = makeMap(type, reversed);
      this.clear(map, reversed);
      state = undefined;
    }
    if (state === undefined) {
      state = watch(map, type);
      this.slots.add(slot);
    }
    if (!state.isWanted) return;
    this.copy(slot, map, atlas, reversed);
    state.isFilled = true;
  }

  /** Resets `shadow.map` to null for a light whose map has no region any more. */
  release(slot: ShadowSlot): void {
    const { map } = slot.shadow;
    if (!this.slots.delete(slot) || map === null || !watched.has(map)) return;
    unwatch(map);
    disposeMap(map);
    slot.shadow.map = null;
  }

  dispose(): void {
    for (const slot of this.slots) this.release(slot);
    this.pass.dispose();
  }

  private clear(map: RenderTarget, reversed: boolean): void {
    const { webgl } = this;
    const gl = webgl.getContext() as WebGL2RenderingContext;
    webgl.setRenderTarget(map as WebGLRenderTarget);
    unmaskColour(webgl);
    unmaskDepth(webgl);
    gl.clearBufferfv(gl.COLOR, 0, reversed ? BLACK : WHITE);
    gl.clearBufferfv(gl.DEPTH, 0, [reversed ? 0 : 1]);
  }

  private copy(slot: ShadowSlot, map: RenderTarget, atlas: TextureAtlas, reversed: boolean): void {
    const { webgl, drawer, uniforms } = this;
    const { maxTextureSize } = webgl.capabilities;
    const width = Math.min(slot.wantedWidth, maxTextureSize);
    const height = Math.min(slot.wantedHeight, maxTextureSize);
    const face = slot.faces[slot.faces.length - 1];
    const moments = map.textures[0].format === RGFormat;
    if (map.width !== width || map.height !== height) map.setSize(width, height);
    uniforms.farol_hostMapAtlas.value = atlas.texture;
    uniforms.farol_hostMapRegion.value.set(face.x, face.y, face.width / width, face.height / height);
    uniforms.farol_hostMapFar.value = reversed ? 0 : 1;
    uniforms.farol_hasMoments.value = moments;
    if (!moments) comparesDepths(webgl, atlas.texture!, false);
    drawer.bind(map as WebGLRenderTarget);
    drawer.drawPart(this.pass, 0, 0, width, height);
    if (!moments) comparesDepths(webgl, atlas.texture!, true);
  }
}
