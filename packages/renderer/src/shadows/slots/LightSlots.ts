import { lightRange } from '../../lights/lightData';
import { sphereCoverage } from '../../lights/spheres';
import { type Camera, type Light, type Object3D, type PointLight, type Texture, Vector3 } from 'three';
import type { AtlasTenant } from '../atlas/TextureAtlas';
import { isBelow } from '../isBelow';
import { CookieSlot } from './CookieSlot';
import type { ImageSamplers } from './ImageSamplers';
import type { ShadowLight } from './ShadowLight';
import { ShadowSlot } from './ShadowSlot';

/** Number of frames for which the shadow map or cookie of a light that no frame uses stays in its atlas. */
const KEPT_FRAMES = 600;

/** Releases atlas regions of shadow maps and cookies. */
export interface SlotRelease {
  map(slot: ShadowSlot): void;
  cookie(cookie: CookieSlot): void;
}

/**
 * Data of the shadow maps, cookies and profiles of all lights: those of the frame, and those kept for a while after.
 */
export class LightSlots {
  /** Layers of casters, as bits, for shadows whose camera selects no layers. */
  layersSeen = 1;
  /** Lights of the frame that have a shadow map, cookie or profile. */
  readonly lit: ShadowSlot[] = [];
  /** Shadow maps that the frame needs in the atlas of depths; written by `sortOut`. */
  readonly depths: ShadowSlot[] = [];
  readonly colours: AtlasTenant[] = [];
  /** Shadow maps that have a region of the atlas of depths, but are not needed in the frame. */
  readonly keptDepths: ShadowSlot[] = [];
  readonly keptColours: AtlasTenant[] = [];
  /** Number of shadow maps that the frame needs. */
  mapCount = 0;
  private readonly slots = new Map<Light, ShadowSlot>();
  /** Cookies by their texture. */
  private readonly images = new Map<Texture, CookieSlot>();
  private readonly profiles = new Map<Texture, CookieSlot>();
  /** All cookies, then all profiles, those kept for later frames included. */
  readonly copies: readonly Map<Texture, CookieSlot>[] = [this.images, this.profiles];
  private frame = 0;

  /**
   * @param mostAnisotropy - greatest anisotropy of the device. Default 1
   * @param samplers - samplers for images; null: all images are copied
   */
  constructor(
    private readonly release: SlotRelease,
    private readonly mostAnisotropy = 1,
    private readonly samplers: ImageSamplers | null = null,
  ) {}

  get isEmpty(): boolean {
    return this.slots.size === 0;
  }

  /** Shadow maps of all lights, those kept for later frames included. */
  all(): Iterable<ShadowSlot> {
    return this.slots.values();
  }

  /** Shadow map of a light of the frame; undefined where the light has none. */
  litSlotOf(light: Light): ShadowSlot | undefined {
    const slot = this.slots.get(light);
    return slot !== undefined && slot.lastLit === this.frame ? slot : undefined;
  }

  /** Whether a light of the frame uses the image or profile. */
  isLit(cookie: CookieSlot): boolean {
    return cookie.lastLit === this.frame;
  }

  begin(frame: number): void {
    this.frame = frame;
    this.lit.length = 0;
  }

  /**
   * Adds a light that casts shadows, projects an image or has a profile.
   * @param cascades - number of maps of a directional light, its whole camera's included; 1 for other lights
   */
  add(
    light: ShadowLight,
    root: Object3D,
    camera: Camera,
    casts: boolean,
    image: Texture | null,
    cascades: number,
    profile: Texture | null = null,
  ): void {
    const slot = this.slotFor(light, cascades);
    slot.enter(root);
    slot.lastLit = this.frame;
    slot.coverage = lightCoverage(light, camera);
    slot.casts = casts;
    slot.cookie = image === null ? null : this.copyOf(image, this.images);
    slot.profile = profile === null ? null : this.copyOf(profile, this.profiles);
    const { mask } = light.shadow.camera.layers;
    // as in three: a shadow camera that has layer 0 alone draws the layers of the picture's camera
    slot.setLayers((mask & 0xfffffffe) !== 0 ? mask : this.layersSeen);
    this.lit.push(slot);
  }

  /**
   * Sorts maps and cookies into those that the frame needs and those kept; releases those not used for long, or removed
   * from their scene.
   * @param inColours - whether shadow maps lie in the atlas of colours, as variance shadow maps do
   */
  sortOut(inColours: boolean): void {
    const { depths, colours, keptDepths, keptColours, frame, release } = this;
    depths.length = colours.length = keptDepths.length = keptColours.length = this.mapCount = 0;
    for (const slot of this.slots.values()) {
      const isLit = slot.lastLit === frame;
      if (!isLit) slot.record = -1;
      if (isLit && slot.casts) {
        this.mapCount++;
        (inColours ? colours : depths).push(slot);
      } else if (
        frame - slot.lastLit > KEPT_FRAMES ||
        (frame - slot.lastLit === 2 && !isBelow(slot.light, slot.root))
      ) {
        release.map(slot);
        this.slots.delete(slot.light);
      } else if (!isLit || slot.placement.region !== null) (inColours ? keptColours : keptDepths).push(slot);
    }
    this.samplers?.assign(this.images, frame);
    for (const copies of this.copies) {
      for (const cookie of copies.values()) {
        if (cookie.sampler >= 0 && cookie.placement.region === null) continue;
        if (cookie.lastLit === frame) (cookie.sampler >= 0 ? keptColours : colours).push(cookie);
        else if (frame - cookie.lastLit > KEPT_FRAMES) {
          release.cookie(cookie);
          copies.delete(cookie.texture);
        } else keptColours.push(cookie);
      }
    }
  }

  /** Marks all shadow maps as lost and, unless `mapsAlone`, all cookies and profiles. */
  lose(mapsAlone: boolean): void {
    for (const slot of this.slots.values()) slot.map.lose();
    if (mapsAlone) return;
    for (const copies of this.copies) for (const cookie of copies.values()) cookie.map.lose();
  }

  /** Releases the shadow maps of a scene, and cookies that no light of another scene uses. */
  releaseScene(root: Object3D): void {
    for (const slot of this.slots.values()) {
      if (slot.root !== root) continue;
      this.release.map(slot);
      this.slots.delete(slot.light);
    }
    for (const copies of this.copies) {
      for (const cookie of copies.values()) {
        if (this.isThrown(cookie)) continue;
        this.release.cookie(cookie);
        copies.delete(cookie.texture);
      }
    }
  }

  clear(): void {
    this.slots.clear();
    this.samplers?.clear();
    for (const copies of this.copies) copies.clear();
  }

  /** Shadow map of a light; a new one if the light's `shadow` object or number of cascades has changed. */
  private slotFor(light: ShadowLight, cascades: number): ShadowSlot {
    let slot = this.slots.get(light);
    if (slot !== undefined && (slot.shadow !== light.shadow || (!slot.isCube && slot.cascades !== cascades - 1))) {
      this.release.map(slot);
      slot = undefined;
    }
    if (slot === undefined) {
      slot = new ShadowSlot(light, cascades);
      this.slots.set(light, slot);
    }
    return slot;
  }

  private copyOf(image: Texture, copies: Map<Texture, CookieSlot>): CookieSlot {
    let cookie = copies.get(image);
    if (cookie === undefined) copies.set(image, (cookie = new CookieSlot(image, copies === this.profiles)));
    if (cookie.lastLit !== this.frame) cookie.follow(this.mostAnisotropy);
    cookie.lastLit = this.frame;
    return cookie;
  }

  private isThrown(cookie: CookieSlot): boolean {
    for (const slot of this.slots.values()) if (slot.cookie === cookie || slot.profile === cookie) return true;
    return false;
  }
}

const position = new Vector3();

/** Approximate share of the picture that a light's range covers, 0 to 1; 1 without a range. */
function lightCoverage(light: Light, camera: Camera): number {
  const range = lightRange(light as PointLight);
  if (range === 0) return 1;
  position.setFromMatrixPosition(light.matrixWorld).applyMatrix4(camera.matrixWorldInverse);
  return sphereCoverage(-position.z, range, camera.projectionMatrix.elements);
}
