import { type Camera, type Light, type Object3D, type Texture, VSMShadowMap, type WebGLRenderer } from 'three';
import type { AtlasTiles } from '../frame/AtlasTiles';
import type { Frame, TileShadows } from '../frame/Frame';
import { RecentlyUsed } from '../frame/RecentlyUsed';
import type { ShadowMaskMaterials } from '../frame/RenderQueue';
import type { GBuffer } from '../gbuffer/GBuffer';
import type { DataTable } from '../gpu/DataTable';
import type { MaskUniforms } from '../lighting/maskUniforms';
import { cookieOf, profileOf } from '../lighting/lightCookie';
import type { LightMasks } from '../lighting/LightRecords';
import { shadowedLights } from '../lighting/shadowedLights';
import { hasShadowMap, isAreaLight } from '../lights/classifyLight';
import type { PictureSize } from '../lights/PictureSize';
import type { MicroShaderRegistry } from '../microshaders';
import { listTiles } from './atlas/listTiles';
import { ShadowAtlases } from './atlas/ShadowAtlases';
import type { TextureAtlas } from './atlas/TextureAtlas';
import { ShadowCasters } from './casters/ShadowCasters';
import type { HostShadowMaps } from './draw/HostShadowMaps';
import type { ShadowMapCalls } from './draw/ShadowMapCalls';
import { PlannedDraws, wasAskedFor } from './draw/PlannedDraws';
import type { ShadowMapDraws } from './draw/ShadowMapDraws';
import { shadowMaskTwin, showsShadowMask } from './masks/shadowMaskTwin';
import { LightLayers } from './LightLayers';
import { MaskRecords } from './masks/MaskRecords';
import { MaskShaders } from './masks/MaskShaders';
import { type ShadowBounds, ShadowTiles } from './screen-tiles';
import type { AreaLightTable } from '../lighting/area-lights/AreaLightTable';
import { AreaShadowLight, softSizeOf } from './slots/AreaShadowLight';
import { atlasLimit, liteAtlasBytes } from './slots/atlasLimit';
import { chooseDetail } from './slots/chooseDetail';
import type { CookieSlot } from './slots/CookieSlot';
import { ImageSamplers, imageSamplersOf } from './slots/ImageSamplers';
import { LightSlots } from './slots/LightSlots';
import type { ShadowLight } from './slots/ShadowLight';
import type { ShadowSlot } from './slots/ShadowSlot';
import { isDepthReversed } from '../three/state';

/** Number of frames from one rebalancing of a full atlas, which chooses anew which maps are halved, to the next. */
const REBALANCE = 60;
/** Minimum side of the atlas of depths (texels). */
const SMALLEST_ATLAS = 512;

/**
 * The shadow maps and cookies of all lights of a renderer, in two atlases. `update` finds which maps a frame needs and which of
 * these are out of date; `render` draws the maps that are. README.md lists the steps of a frame.
 */
export class ShadowMaps implements LightMasks, TileShadows {
  /** Test for materials that show nothing but shadows (such as ShadowMaterial), and the twin that draws them. */
  readonly maskMaterials: ShadowMaskMaterials = { shows: showsShadowMask, twin: shadowMaskTwin };
  readonly layers = new LightLayers();
  /** Number of maps for each directional light, 1 to 4. */
  cascades = 1;
  /** Greatest side of the atlas of shadow-map depths (texels); null: by the size of pictures, see `atlasLimit`. */
  atlasSize: number | null = null;
  private knownAtlasSize: number | null = null;
  /** Whether the atlases are limited in bytes, for the quality 'lite'. */
  isLite = false;
  /** Bytes of a depth texel when the limit in bytes was computed; 0 without a limit. */
  private knownTexel = 0;
  /** Area lights, read for the range of those that cast shadows; null until a scene has an area light. */
  areas: AreaLightTable | null = null;
  /** Camera of the frame, or the array that contains it: chooses levels of detail, and layers of most shadows' casters. */
  seenBy!: Camera;
  /** Number of maps that the frame draws (a point light has one, of six faces). */
  drawn = 0;
  /** Number of shadow maps that the frame uses without drawing them, since they are valid. */
  kept = 0;
  /** Number of shadow-map texels that are drawn anew in the frame. */
  texels = 0;
  readonly bounds: ShadowBounds;
  readonly tiles = new ShadowTiles();
  /** Draws the maps at the moment when three draws its own; set by `makeShadowMaps`. */
  calls!: ShadowMapCalls;
  readonly slots: LightSlots;
  private readonly samplers: ImageSamplers;
  private readonly casters = new WeakMap<Object3D, ShadowCasters>();
  /** Scenes whose shadow maps are in the atlas, the longest unused of them released first. */
  private readonly scenes = new RecentlyUsed<Object3D>((root) => this.releaseScene(root));
  readonly atlases: ShadowAtlases;
  private readonly planned: PlannedDraws;
  private readonly draws: ShadowMapDraws;
  private readonly hostMaps: HostShadowMaps;
  private readonly shaders: MaskShaders;
  private readonly masks: MaskRecords;
  /** `shadowMap.type` of the frame. */
  private type = -1;
  isVariance = false;
  private frame = 0;
  /** Size of the frame's picture (pixels). */
  private picture: PictureSize & Pick<Frame, 'hasMedia'> = { width: 1, height: 1, hasMedia: false };
  /** Number of shadow maps that the last frame needed. */
  private mapCount = 0;

  constructor(
    private readonly webgl: WebGLRenderer,
    microshaders: MicroShaderRegistry,
  ) {
    this.atlases = new ShadowAtlases(webgl);
    this.planned = new PlannedDraws(webgl, microshaders, this.atlases);
    this.draws = this.planned.casters;
    this.hostMaps = this.planned.hostMaps;
    this.bounds = this.planned.bounds;
    const { maxTextures } = webgl.capabilities;
    this.samplers = new ImageSamplers(imageSamplersOf(maxTextures));
    this.shaders = new MaskShaders(microshaders, this.samplers.textures.length);
    const release = {
      map: (slot: ShadowSlot) => this.releaseMap(slot),
      cookie: (cookie: CookieSlot) => this.atlases.colours.release(cookie),
    };
    this.slots = new LightSlots(release, webgl.capabilities.getMaxAnisotropy(), this.samplers);
    this.masks = new MaskRecords(this.slots, this.layers, this.shaders);
  }

  /** Depths of all shadow maps, for a shadow sampler; null before the first map is drawn. */
  get depthTexture(): Texture | null {
    const draws = this.planned.maps.length > 0 && !this.isVariance;
    return this.atlases.textureOf(this.atlases.depths, draws);
  }

  /** Colours of cookies and moments of variance shadow maps, in one texture; null before the first is drawn. */
  get colourTexture(): Texture | null {
    const { images, maps } = this.planned;
    const draws = images.length > 0 || (maps.length > 0 && this.isVariance);
    return this.atlases.textureOf(this.atlases.colours, draws);
  }

  get atlasBytes(): number {
    return this.atlases.bytes + this.planned.bytes;
  }

  get bytes(): number {
    return this.atlasBytes + this.hostMaps.bytes + this.bounds.bytes + this.tiles.bytes;
  }

  /** Whether the frame has shadow maps, cookies or depth bounds of maps to draw. */
  get hasWork(): boolean {
    return this.planned.hasWork;
  }

  /** Proxies of the casters that the frame draws, by which three updates their buffers. */
  get proxies(): readonly Object3D[] {
    return this.draws.proxies;
  }

  get records(): number {
    return this.masks.records;
  }

  recordOf(light: Light): number {
    return this.masks.recordOf(light);
  }

  write(table: DataTable, first: number, camera: Camera): void {
    this.masks.write(table, first, camera, this.type, isDepthReversed(this.webgl), this.picture);
  }

  /**
   * Sets the uniforms of masks for the frame. Call once the light table is written.
   * @param firstMask - index of the first mask's record in the light table
   */
  setUniforms(uniforms: MaskUniforms, firstMask: number, camera: Camera): void {
    uniforms.farol_worldAxes.value.setFromMatrix4(camera.matrixWorldInverse).invert();
    uniforms.farol_shadowAtlas.value = this.depthTexture;
    uniforms.farol_lightAtlas.value = this.colourTexture;
    uniforms.farol_images.value = this.samplers.textures;
    uniforms.farol_atlasTexel.value[0] = 1 / this.atlases.depths.size;
    uniforms.farol_atlasTexel.value[1] = 1 / this.atlases.colours.size;
    uniforms.farol_masks.value[0] = firstMask;
    uniforms.farol_masks.value[1] = this.masks.count;
    uniforms.farol_layers.value[0] = this.layers.reference & 0xffff;
    uniforms.farol_layers.value[1] = this.layers.reference >>> 16;
  }

  /**
   * Finds which maps a frame needs and which of them have to be drawn.
   * @param lights - lights of the frame that may cast shadows, project images or be limited to layers
   * @param picture - size (pixels); `hasMedia`: whether fog samples the maps too
   */
  update(root: Object3D, camera: Camera, lights: readonly Light[], picture: ShadowMaps['picture']): void {
    this.begin();
    this.scenes.use(root);
    if (lights.length === 0 && this.slots.isEmpty) return;
    const { shadowMap } = this.webgl;
    const updates = shadowMap.autoUpdate || shadowMap.needsUpdate;

    this.followType();
    for (const light of lights) this.collect(light, root, camera);

    // maps that are still valid are kept; after a lost context none is
    if (this.atlases.isLost) this.slots.lose(false);
    this.noteChanges(root, camera);
    this.followLights(updates, camera);

    // assign regions and records
    this.picture = picture;
    this.chooseSizes(camera, picture);
    this.place();
    for (const slot of this.slots.lit) this.assign(slot, updates);
    this.masks.end();
    this.planned.planImages(this.slots);
  }

  /** Reuses the maps of the last frame, for the second eye of a headset. */
  keep(): void {
    this.planned.begin();
  }

  /** Draws the frame's maps, images and bounds. Call inside three's `render`, where three draws its own shadow maps. */
  render(): void {
    this.planned.render(this.type);
  }

  /** Finds the screen tiles that a light's shadow map leaves wholly lit, or wholly dark. */
  findTileShadows(frame: Frame, gbuffer: GBuffer): void {
    this.tiles.render(frame, gbuffer, this.bounds.target);
  }

  listTiles(images: boolean): AtlasTiles {
    return listTiles(this, images);
  }

  /** Ends a frame: resets `needsUpdate` of shadows, by which the host requests one draw of a map. */
  end(): void {
    const { shadowMap } = this.webgl;
    if (this.slots.lit.length > 0 && shadowMap.needsUpdate) shadowMap.needsUpdate = false;
  }

  dispose(): void {
    this.atlases.dispose();
    this.planned.dispose();
    this.tiles.dispose();
    this.shaders.dispose();
    this.slots.clear();
    this.scenes.clear();
  }

  private begin(): void {
    this.frame++;
    this.planned.begin();
    this.tiles.bounded = 0;
    this.drawn = this.kept = this.texels = 0;
    this.slots.begin(this.frame);
    this.slots.layersSeen = this.seenBy.layers.mask;
    this.masks.begin();
  }

  // ---- Collect: a slot for each light that casts shadows or projects an image ----

  /** Draws all maps anew after `shadowMap.type` has changed; variance shadow maps lie in the atlas of colours. */
  private followType(): void {
    const { type } = this.webgl.shadowMap;
    if (type === this.type) return;
    const atlas = this.atlasOfMaps;
    const moves = (type === VSMShadowMap) !== this.isVariance;
    for (const slot of this.slots.all()) {
      slot.map.change();
      if (moves) atlas.release(slot);
    }
    this.type = type;
    this.isVariance = type === VSMShadowMap;
  }

  /** Gives a light with shadows, cookie or profile a slot; a light that is only limited to layers needs none. */
  private collect(light: Light, root: Object3D, camera: Camera): void {
    const casts = hasShadowMap(light, shadowedLights(this.webgl));
    const isArea = isAreaLight(light);
    const isDirectional = 'isDirectionalLight' in light;
    const image = isArea ? null : cookieOf(light);
    const profile = isArea || isDirectional ? null : profileOf(light);
    if (!casts && image === null && profile === null) {
      this.masks.addLayered(light);
      return;
    }
    const lit = isArea ? AreaShadowLight.follow(light, this.areas?.radiusOf(light) || 0) : light;
    const cascades = isDirectional && !this.isVariance ? this.cascades : 1;
    this.slots.add(lit as ShadowLight, root, camera, casts, image, cascades, profile);
  }

  // ---- Keep: which of the drawn maps are still valid ----

  /** Marks maps as stale that show a place where a caster has changed, also maps of lights outside of this frame. */
  private noteChanges(root: Object3D, camera: Camera): void {
    let casters = this.casters.get(root);
    if (casters === undefined) this.casters.set(root, (casters = new ShadowCasters()));
    casters.update(root, this.seenBy, this.isVariance);
    this.draws.begin(casters, camera, this.isVariance);
    const { changes, changeCount } = casters;
    for (const slot of this.slots.all()) {
      if (slot.root !== root || slot.map.isStale) continue;
      for (let i = 0; i < changeCount * 4; i += 4) {
        if (!slot.reaches(changes[i], changes[i + 1], changes[i + 2], changes[i + 3])) continue;
        slot.map.change();
        break;
      }
    }
  }

  /** Moves the cameras of maps that may be drawn to the lights, and marks as stale the maps that this changes. */
  private followLights(updates: boolean, camera: Camera): void {
    const reversed = isDepthReversed(this.webgl);
    for (const slot of this.slots.lit) {
      const { shadow, map } = slot;
      if (shadow.needsUpdate) map.change();
      const follows = !map.wasDrawn || slot.cookie !== null || (updates && (shadow.autoUpdate || shadow.needsUpdate));
      if (follows) slot.follow(reversed, camera, this.isVariance);
    }
  }

  // ---- Assign: regions of the atlases, planned draws, records ----

  /** Chooses the sizes of the maps and their atlas. */
  private chooseSizes(camera: Camera, picture: PictureSize): void {
    const { atlases, atlasSize } = this;
    const { lit, copies } = this.slots;
    const texel = this.isLite ? atlases.depths.bytesPerTexel() : 0;
    if (atlasSize !== this.knownAtlasSize || texel !== this.knownTexel) {
      this.knownAtlasSize = atlasSize;
      this.knownTexel = texel;
      for (const slot of this.slots.all()) this.releaseMap(slot);
      for (const cookies of copies) for (const one of cookies.values()) atlases.colours.release(one);
      atlases.clear();
    }
    const asked = atlasSize === null ? atlasLimit(picture, lit) : Math.max(SMALLEST_ATLAS, atlasSize);
    atlases.raiseLimits(asked, this.isLite ? liteAtlasBytes(picture) : Infinity);
    chooseDetail(lit, camera, picture, this.webgl.shadowMap, atlases.depths.reduced);
  }

  /** Gives each shadow map and cookie of the frame its atlas region; releases regions not used for many frames. */
  private place(): void {
    const { slots, atlases } = this;
    slots.sortOut(this.isVariance);
    const rebalances = slots.mapCount !== this.mapCount || this.frame % REBALANCE === 0;
    this.mapCount = slots.mapCount;
    if (!atlases.isFine && slots.depths.some(needsFineDepth)) {
      atlases.refine();
      slots.lose(true);
    }
    atlases.depths.arrange(slots.depths, slots.keptDepths, rebalances);
    atlases.colours.arrange(slots.colours, slots.keptColours, rebalances);
  }

  /** Decides whether the map of a light of the frame is drawn, kept, or copied for three's addons; gives it a mask record. */
  private assign(slot: ShadowSlot, updates: boolean): void {
    const { map, shadow } = slot;
    const mayDraw = (updates && (shadow.autoUpdate || shadow.needsUpdate)) || (!map.isThere && wasAskedFor(slot));
    // a light whose map was neither drawn nor requested casts no shadow
    slot.hasShadow = slot.casts && slot.placement.region !== null && (map.isThere || mayDraw);
    if (slot.hasShadow) {
      const draws = this.planMap(slot, mayDraw);
      if (this.hostMaps.wants(slot, draws, this.type)) this.planned.copies.push(slot);
    }
    this.masks.assign(slot, this.type);
  }

  /** Plans the draw of a map if it is out of date. @returns whether it will be drawn */
  private planMap(slot: ShadowSlot, mayDraw: boolean): boolean {
    const { map } = slot;
    // fog and soft shadows of area lights sample maps far from visible receivers; other cameras of an array see other receivers
    const isWhole = this.picture.hasMedia || softSizeOf(slot.light) > 0 || 'isArrayCamera' in this.seenBy;
    const isPart = !isWhole && this.draws.isPart(slot, mayDraw, this.frame) && !this.hostMaps.isWatched(slot);
    if ((mayDraw && !map.isCurrent) || (map.isPartial && !isPart)) {
      this.planned.maps.push(slot);
      this.drawn++;
      this.texels += slot.plan(isPart);
      this.draws.prepare(slot);
      return true;
    }
    this.kept++;
    if (map.hasBounds) this.tiles.bounded++;
    else if (!this.isVariance) this.bounds.keep(slot, this.frame - map.since);
    return false;
  }

  // ---- Release ----

  private releaseMap(slot: ShadowSlot): void {
    this.hostMaps.release(slot);
    this.atlasOfMaps.release(slot);
  }

  private releaseScene(root: Object3D): void {
    this.slots.releaseScene(root);
    const casters = this.casters.get(root);
    if (casters !== undefined) this.draws.release(casters);
    this.casters.delete(root);
  }

  private get atlasOfMaps(): TextureAtlas {
    return this.isVariance ? this.atlases.colours : this.atlases.depths;
  }
}

const needsFineDepth = (slot: ShadowSlot) => slot.needsFineDepth;
