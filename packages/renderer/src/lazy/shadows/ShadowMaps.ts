import {
  type Camera,
  type Light,
  type Object3D,
  type Texture,
  VSMShadowMap,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';
import { lacksFloatTargets } from '../../gpu/checkDevice';
import type { DataTable } from '../../gpu/DataTable';
import { cookieOf } from '../../lighting/lightCookie';
import { LightLayers } from './LightLayers';
import { ELSEWHERE } from '../../lights/lightRecord';
import type { LightMasks } from '../../lighting/LightRecords';
import type { LightTable, PictureSize } from '../../lighting/LightTable';
import type { MicroShaderRegistry } from '../../microshaders';
import { RecentlyUsed } from '../../frame/RecentlyUsed';
import { atlasLimit } from './slots/atlasLimit';
import { colourTarget } from './atlas/colourTarget';
import { CookieDraws } from './draw/CookieDraws';
import { CookieSlot } from './slots/CookieSlot';
import { depthTarget } from './atlas/depthTarget';
import { lightCoverage } from './slots/lightCoverage';
import { RECORDS_PER_MASK, shadowKindOf, writeLayerMask, writeMask } from './masks/maskRecord';
import { maskKinds, maskKindsOf, maskLoopOf } from './masks/maskKinds';
import { MaskShaders } from './masks/MaskShaders';
import type { MaskUniforms } from '../../lighting/maskUniforms';
import { MomentDraws } from './draw/MomentDraws';
import { ShadowCasters } from './casters/ShadowCasters';
import { ShadowMapDraws } from './draw/ShadowMapDraws';
import { type ShadowLight, ShadowSlot } from './slots/ShadowSlot';
import { ShownMaps } from './draw/ShownMaps';
import { settleSizes } from './slots/settleSizes';
import { type AtlasTenant, TileAtlas } from './atlas/TileAtlas';
import { ShadowBounds, ShadowTiles } from './screen-tiles';

/** Frames of its scene for which the tile of a light or image that is not lit is kept. */
const KEPT_FRAMES = 600;
/** Frames between looks at whose tiles are halved, when an atlas is full. */
const REBALANCE = 60;
/** Texels a side of the atlas of colours at most. */
const LARGEST_COLOURS = 4096;

/**
 * The shadow maps and cookies of all lights of a renderer, in two atlases: which of them are to be drawn this frame, and the
 * drawing. A map is kept until something that casts shadows changes within its view, or the light does.
 */
export class ShadowMaps implements LightMasks {
  records = 0;
  readonly layers = new LightLayers();
  /** Maps of each directional light, 1 to 4. */
  cascades = 1;
  /** Maps that this frame draws (a point light has one of six faces), and those that it lights with as they are. */
  drawn = 0;
  kept = 0;
  /** Texels that are drawn to for that. */
  texels = 0;
  private readonly slots = new Map<Light, ShadowSlot>();
  private readonly cookies = new Map<Texture, CookieSlot>();
  /** Lights that have no slot, but do not reach all layers, and their records. */
  private readonly layered = new Map<Light, number>();
  private readonly lit: ShadowSlot[] = [];
  private readonly stale: ShadowSlot[] = [];
  private readonly unlit: AtlasTenant[] = [];
  private readonly mapped: ShadowSlot[] = [];
  private readonly coloured: AtlasTenant[] = [];
  private readonly staleCookies: CookieSlot[] = [];
  private readonly casters = new WeakMap<Object3D, ShadowCasters>();
  /** Scenes whose maps are held. */
  private readonly scenes = new RecentlyUsed<Object3D>((root) => this.releaseScene(root));
  private readonly depths: TileAtlas;
  private readonly colours: TileAtlas;
  private readonly draws: ShadowMapDraws;
  private readonly moments: MomentDraws;
  private readonly images: CookieDraws;
  private readonly shown: ShownMaps;
  /** Lights whose maps are copied to where three's addons look for them. */
  private readonly toShow: ShadowSlot[] = [];
  readonly bounds: ShadowBounds;
  readonly tiles = new ShadowTiles();
  private readonly shaders: MaskShaders;
  /** Depths have 24 bits, since a light that was met needs them; 16 before. */
  private isFine = false;
  private type = -1;
  private frame = 0;
  private tenants = 0;

  /** @param limit of the atlas of depths, texels a side; null: by the pictures that are drawn, see `atlasLimit` */
  constructor(
    private readonly webgl: WebGLRenderer,
    microshaders: MicroShaderRegistry,
    private readonly limit: number | null,
  ) {
    const { maxTextureSize } = webgl.capabilities;
    this.depths = new TileAtlas(
      0,
      () => (this.isFine ? 5 : 3),
      (size) => depthTarget(size, this.isFine),
    );
    const floats = lacksFloatTargets(webgl) === null;
    this.colours = new TileAtlas(
      Math.min(LARGEST_COLOURS, maxTextureSize),
      () => (floats ? 8 : 4),
      (size) => colourTarget(size, floats),
    );
    this.draws = new ShadowMapDraws(webgl, microshaders);
    this.moments = new MomentDraws(webgl, microshaders, this.draws);
    this.images = new CookieDraws(webgl, microshaders);
    this.shown = new ShownMaps(webgl, microshaders);
    this.bounds = new ShadowBounds(webgl, microshaders);
    this.shaders = new MaskShaders(microshaders);
  }

  /** Depths of the maps, to be compared by the sampler; null before the first is drawn. */
  get depthTexture(): Texture | null {
    const draws = this.stale.length > 0 && this.type !== VSMShadowMap;
    return draws || !this.isLost(this.depths) ? this.depths.texture : null;
  }

  /** Colours of cookies, moments of variance shadow maps; null before the first is drawn. */
  get colourTexture(): Texture | null {
    const draws = this.staleCookies.length > 0 || (this.stale.length > 0 && this.type === VSMShadowMap);
    return draws || !this.isLost(this.colours) ? this.colours.texture : null;
  }

  get atlasBytes(): number {
    return this.depths.bytes + this.colours.bytes + this.moments.bytes;
  }

  get bytes(): number {
    return this.atlasBytes + this.bounds.bytes + this.tiles.bytes;
  }

  /** Points the uniforms at what lights the frame, once the light table is written. */
  setUniforms(uniforms: MaskUniforms, lights: LightTable, camera: Camera): void {
    uniforms.farol_worldAxes.value.setFromMatrix4(camera.matrixWorld);
    uniforms.farol_shadowAtlas.value = this.depthTexture;
    uniforms.farol_lightAtlas.value = this.colourTexture;
    uniforms.farol_atlasTexel.value[0] = 1 / this.depths.size;
    uniforms.farol_atlasTexel.value[1] = 1 / this.colours.size;
    const masks = uniforms.farol_masks.value;
    masks[0] = lights.firstMask;
    masks[1] = this.records / RECORDS_PER_MASK;
    const layers = uniforms.farol_layers.value;
    layers[0] = this.layers.reference & 0xffff;
    layers[1] = this.layers.reference >>> 16;
  }

  /** True when the frame has maps or cookies to draw. */
  get hasWork(): boolean {
    return this.stale.length + this.staleCookies.length + this.toShow.length > 0 || this.bounds.hasWork;
  }

  /** Stand-ins of the casters that are drawn this frame, for three to bring their buffers up to date. */
  get stands(): readonly Object3D[] {
    return this.draws.stands;
  }

  /**
   * Finds out which maps a frame needs and which of them have to be drawn.
   * @param lights those that may be masked, of this frame
   */
  update(root: Object3D, camera: Camera, lights: readonly Light[], picture: PictureSize): void {
    this.frame++;
    this.lit.length = this.stale.length = this.staleCookies.length = this.toShow.length = this.tiles.bounded = 0;
    this.bounds.begin();
    this.records = this.drawn = this.kept = this.texels = 0;
    if (this.layered.size > 0) this.layered.clear();
    this.scenes.use(root);
    if (lights.length === 0 && this.slots.size === 0) return;
    const { shadowMap, capabilities } = this.webgl;
    this.followType();
    for (const light of lights) this.addLight(light, root, camera);
    this.dropLost();
    this.findChanges(root, camera);
    const updates = shadowMap.autoUpdate || shadowMap.needsUpdate;
    this.follow(updates, camera);
    // as the largest picture needs it: cameras may take turns
    this.depths.raiseLimit(Math.min(this.limit ?? atlasLimit(picture, this.lit), capabilities.maxTextureSize));
    settleSizes(this.lit, camera, picture, shadowMap, this.depths.reduced);
    this.arrange();
    this.findStale(updates);
    this.shaders.adapt(this.records > 0, this.layers.reference !== 0);
  }

  recordOf(light: Light): number {
    const slot = this.slots.get(light);
    if (slot === undefined || slot.used !== this.frame) return this.layered.get(light) ?? -1;
    return slot.record >= 0 && slot.isLeft ? slot.record + ELSEWHERE : slot.record;
  }

  write(table: DataTable, first: number, camera: Camera): void {
    const reversed = this.webgl.state.buffers.depth.getReversed();
    for (const slot of this.lit) {
      if (slot.record < 0) continue;
      const reached = this.layers.separates(slot.light) ? slot.light.layers.mask : 0;
      writeMask(table, first + slot.record, slot, shadowKindOf(slot, this.type), camera, reversed, reached);
    }
    for (const [light, record] of this.layered) writeLayerMask(table, first + record, light.layers.mask);
  }

  /** Draws what is to be drawn. Call inside three's `render`, where it draws its own shadow maps. */
  render(): void {
    const { webgl, stale, depths, colours } = this;
    const target = webgl.getRenderTarget() as WebGLRenderTarget | null;
    const face = webgl.getActiveCubeFace();
    const level = webgl.getActiveMipmapLevel();
    this.draws.setComparison(depths);
    this.draws.send();
    if (this.type === VSMShadowMap) for (const slot of stale) this.moments.render(slot, colours);
    else if (stale.length > 0) {
      webgl.setRenderTarget(depths.target);
      this.draws.drawMaps(stale);
    }
    for (const slot of stale) {
      slot.dirty = false;
      slot.drawn = slot.hadMap = true;
      const { shadow } = slot.light;
      if (shadow.needsUpdate) shadow.needsUpdate = false;
    }
    for (const cookie of this.staleCookies) this.images.render(cookie, colours);
    for (const slot of this.toShow) this.shown.render(slot, this.type === VSMShadowMap ? colours : depths, this.type);
    this.bounds.render(depths);
    webgl.setRenderTarget(target, face, level);
  }

  /** Ends a frame: what the host asked for once is done. */
  end(): void {
    const { shadowMap } = this.webgl;
    if (this.lit.length > 0 && shadowMap.needsUpdate) shadowMap.needsUpdate = false;
  }

  dispose(): void {
    this.depths.dispose();
    this.colours.dispose();
    this.draws.dispose();
    this.moments.dispose();
    this.images.dispose();
    this.bounds.dispose();
    this.shown.dispose();
    this.tiles.dispose();
    this.shaders.dispose();
    this.slots.clear();
    this.cookies.clear();
    this.scenes.clear();
  }

  /** Lets go of the maps of a scene, its casters, and images that no light of another scene throws. */
  private releaseScene(root: Object3D): void {
    for (const slot of this.slots.values()) {
      if (slot.root !== root) continue;
      this.releaseMap(slot);
      this.slots.delete(slot.light);
    }
    for (const cookie of this.cookies.values()) {
      if (this.isThrown(cookie)) continue;
      this.colours.release(cookie);
      this.cookies.delete(cookie.texture);
    }
    const casters = this.casters.get(root);
    if (casters !== undefined) this.draws.release(casters);
    this.casters.delete(root);
  }

  private isThrown(cookie: CookieSlot): boolean {
    for (const slot of this.slots.values()) if (slot.cookie === cookie) return true;
    return false;
  }

  /** Another type of maps is drawn otherwise, and variance shadow maps lie elsewhere. */
  private followType(): void {
    const { type } = this.webgl.shadowMap;
    if (type === this.type) return;
    const atlas = this.type === VSMShadowMap ? this.colours : this.depths;
    const moves = (type === VSMShadowMap) !== (this.type === VSMShadowMap);
    for (const slot of this.slots.values()) {
      slot.dirty = true;
      if (moves) atlas.release(slot);
    }
    this.type = type;
  }

  private addLight(anyLight: Light, root: Object3D, camera: Camera): void {
    const { enabled } = this.webgl.shadowMap;
    const light = anyLight as ShadowLight;
    const casts = light.castShadow && enabled && !(this.type === VSMShadowMap && light.isPointLight === true);
    const image = cookieOf(light);
    if (!casts && image === null) {
      if (this.layers.separates(light)) this.layered.set(light, -1);
      return;
    }
    let slot = this.slots.get(light);
    const mayCascade = (light as { isDirectionalLight?: boolean }).isDirectionalLight && this.type !== VSMShadowMap;
    const cascades = mayCascade ? this.cascades : 1;
    if (slot !== undefined && (slot.shadow !== light.shadow || (!slot.isCube && slot.cascades !== cascades - 1))) {
      this.releaseMap(slot);
      slot = undefined;
    }
    if (slot === undefined) {
      slot = new ShadowSlot(light, cascades);
      this.slots.set(light, slot);
    }
    slot.enter(root);
    slot.used = this.frame;
    slot.coverage = lightCoverage(light, camera);
    slot.casts = casts;
    slot.cookie = image === null ? null : this.cookieFor(image);
    const { mask } = light.shadow.camera.layers;
    const layers = (mask & 0xfffffffe) !== 0 ? mask : camera.layers.mask;
    if (slot.layers !== layers) {
      slot.layers = layers;
      slot.dirty = true;
    }
    this.lit.push(slot);
  }

  private cookieFor(image: Texture): CookieSlot {
    let cookie = this.cookies.get(image);
    if (cookie === undefined) this.cookies.set(image, (cookie = new CookieSlot(image)));
    if (cookie.used !== this.frame) cookie.follow();
    cookie.used = this.frame;
    return cookie;
  }

  /** Marks the maps that see something that changed; also those of lights that are not lit now. */
  private findChanges(root: Object3D, camera: Camera): void {
    let casters = this.casters.get(root);
    if (casters === undefined) this.casters.set(root, (casters = new ShadowCasters()));
    casters.update(root, camera, this.type === VSMShadowMap);
    this.draws.begin(casters, camera, this.type === VSMShadowMap);
    const { changes, changed } = casters;
    for (const slot of this.slots.values()) {
      if (slot.root !== root) continue;
      for (let i = 0; i < changed * 4 && !slot.dirty; i += 4) {
        if (slot.reaches(changes[i], changes[i + 1], changes[i + 2], changes[i + 3])) slot.dirty = true;
      }
    }
  }

  private follow(updates: boolean, camera: Camera): void {
    const reversed = this.webgl.state.buffers.depth.getReversed();
    for (const slot of this.lit) {
      const { shadow } = slot.light;
      if (shadow.needsUpdate) slot.dirty = true;
      const follows = !slot.hadMap || slot.cookie !== null || (updates && (shadow.autoUpdate || shadow.needsUpdate));
      if (follows) slot.follow(reversed, camera, this.type === VSMShadowMap);
    }
  }

  /** Gives everything that is lit its tile, and lets go of what has not been lit for long. */
  private arrange(): void {
    const { mapped, coloured, unlit } = this;
    const vsm = this.type === VSMShadowMap;
    mapped.length = coloured.length = unlit.length = 0;
    for (const slot of this.slots.values()) {
      if (slot.used === this.frame) {
        if (slot.casts) (vsm ? (coloured as AtlasTenant[]) : mapped).push(slot);
        continue;
      }
      slot.record = -1;
      if (this.frame - slot.used > KEPT_FRAMES) {
        this.releaseMap(slot);
        this.slots.delete(slot.light);
      } else unlit.push(slot);
    }
    const keptMaps = vsm ? NONE : unlit;
    const count = mapped.length + coloured.length;
    const look = count !== this.tenants || this.frame % REBALANCE === 0;
    this.tenants = count;
    if (!this.isFine && !vsm && mapped.some((slot) => slot.needsFineDepth)) this.refine();
    this.depths.arrange(mapped, keptMaps, look);
    if (!vsm) unlit.length = 0;
    for (const cookie of this.cookies.values()) {
      if (cookie.used === this.frame) coloured.push(cookie);
      else if (this.frame - cookie.used > KEPT_FRAMES) {
        this.colours.release(cookie);
        this.cookies.delete(cookie.texture);
      } else unlit.push(cookie);
    }
    this.colours.arrange(coloured, unlit, look);
  }

  /** Depths of 24 bits from now on. */
  private refine(): void {
    this.isFine = true;
    this.depths.remake();
    for (const slot of this.slots.values()) slot.drawn = false;
  }

  private findStale(updates: boolean): void {
    for (const slot of this.lit) {
      const { shadow } = slot.light;
      const may = (updates && (shadow.autoUpdate || shadow.needsUpdate)) || (slot.hadMap && !slot.drawn);
      // a light whose first map may not be drawn yet casts no shadow
      slot.shows = slot.casts && slot.tile !== null && (slot.drawn || may);
      const isPart = slot.shows && this.draws.isPart(slot, may, this.frame) && !this.shown.isWatched(slot);
      if (slot.shows && ((may && (slot.dirty || !slot.drawn)) || (slot.isPartial && !isPart))) {
        this.stale.push(slot);
        this.drawn++;
        this.texels += slot.draws(isPart);
        this.draws.prepare(slot);
        slot.isBounded = false;
      } else if (slot.shows) {
        this.kept++;
        if (slot.isBounded) this.tiles.bounded++;
        else if (this.type !== VSMShadowMap) this.bounds.keep(slot, this.frame - slot.changed);
      }
      if (slot.shows && this.shown.wants(slot, this.stale[this.stale.length - 1] === slot, this.type))
        this.toShow.push(slot);
      const masked = slot.shows || slot.cookie !== null || this.layers.separates(slot.light);
      slot.record = masked ? this.records : -1;
      if (slot.record >= 0) this.records += RECORDS_PER_MASK;
      if (masked) this.shaders.need(maskKindsOf(slot, this.type));
    }
    for (const light of this.layered.keys()) {
      this.shaders.need(maskKinds.unshadowed | maskLoopOf(light));
      this.layered.set(light, this.records);
      this.records += RECORDS_PER_MASK;
    }
    for (const cookie of this.cookies.values()) {
      if (cookie.used === this.frame && cookie.tile !== null && !cookie.drawn) this.staleCookies.push(cookie);
    }
  }

  private releaseMap(slot: ShadowSlot): void {
    this.shown.release(slot);
    (this.type === VSMShadowMap ? this.colours : this.depths).release(slot);
  }

  /** A lost context takes the maps along. */
  private dropLost(): void {
    if (this.isLost(this.depths) || this.isLost(this.colours)) {
      for (const slot of this.slots.values()) slot.drawn = false;
      for (const cookie of this.cookies.values()) cookie.drawn = false;
    }
  }

  private isLost({ texture }: TileAtlas): boolean {
    if (texture === null) return false;
    return (this.webgl.properties.get(texture) as { __webglTexture?: WebGLTexture }).__webglTexture === undefined;
  }
}

const NONE: readonly AtlasTenant[] = [];
