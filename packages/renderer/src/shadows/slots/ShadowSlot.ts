import {
  type Camera,
  Frustum,
  type LightShadow,
  Object3D,
  Matrix4,
  OrthographicCamera,
  type PointLight,
  type SpotLight,
  Vector3,
} from 'three';
import { rangeOf } from '../../lights/plainPoints';
import { sphereOutsidePlanes } from '../../lights/spheres';
import { AtlasMap } from '../atlas/AtlasMap';
import { AtlasPlacement } from '../atlas/AtlasPlacement';
import { MapDetail } from '../atlas/MapDetail';
import type { AtlasTenant } from '../atlas/TextureAtlas';
import type { CookieSlot } from './CookieSlot';
import { needsFineDepth } from './fineDepth';
import { fitCascade } from './fitCascade';
import { placeShadowCamera } from './placeShadowCamera';
import { isBeyond, makeReach, setReach } from './reach';
import { aimCubeFace, makeCubeFaces, ShadowFace } from './ShadowFace';
import type { PrivateLightShadow, ShadowCamera, ShadowLight } from './ShadowLight';
import { MATTERING_RANGE } from './sufficientDetail';
import { setReversedDepth } from '../../three/reversedDepth';
import { standInOf } from '../../three/standInOf';
import { SHADOW_FRUSTUM } from '../../three/shadowFrustum';

/** Greatest distance of a filter sample along a face (in filter radii): the disk is slanted at the face's corners. */
const FARTHEST = 1.17;
/** Greatest border (texels); three bits of a mask hold its power of two. */
const LARGEST_BORDER = 128;

const CAMERA_NUMBERS = ['near', 'zoom', 'left', 'right', 'top', 'bottom'] as const;
const position = new Vector3();
const fitted = new Float64Array(4);

function cascadeCamera(): OrthographicCamera {
  const camera = new OrthographicCamera();
  camera.matrixAutoUpdate = camera.matrixWorldAutoUpdate = false;
  return camera;
}

/**
 * Shadow map of one light: its cameras, its region of the atlas, and what the region holds. While drawing, three changes the
 * light's shadow (camera, matrix); Farol makes these changes on a proxy that inherits its settings, and leaves the light's own
 * shadow in the state that three would leave.
 */
export class ShadowSlot implements AtlasTenant {
  readonly isCube: boolean;
  /** The light's own shadow object; Farol changes only properties that three changes too. */
  readonly shadow: LightShadow;
  /** Faces of the map: one for each cascade, then one for the light's whole shadow camera; six of a cube. */
  readonly faces: ShadowFace[];
  /** Number of cascades: maps of the space near the viewer's camera, besides the map of the light's whole shadow camera. */
  readonly cascades: number;
  /** Number of maps along a side of the square that the cascades form. */
  readonly side: number;
  /** Transform of coordinates in the whole camera's map to each cascade's: scale and shift of x, scale and shift of y. */
  readonly fits: Float64Array;
  /** Transform from world space to the map (0 to 1) and depth; for a point light: to the vector from the light. */
  readonly matrix = new Matrix4();
  /** Near plane of the map's cameras (m). */
  near = 0;
  far = 0;

  /** Region of the map in the atlas; written by the atlas. */
  readonly placement = new AtlasPlacement();
  /** State of the shadow map in its region of the atlas. */
  readonly map = new AtlasMap();
  /** Number of halvings of the map because pictures would show no more detail; set by `chooseDetail` and the atlas. */
  readonly detail = new MapDetail();

  // fields below: set in each frame, when slots are collected
  /** The scene of the last frame that used the light. */
  root: Object3D | null = null;
  /** Number of the last frame that used the light. */
  lastLit = 0;
  /** Share of the picture that the light covers, 0 to 1. */
  coverage = 1;
  /** Whether the light casts shadows. */
  casts = false;
  /** Texture that the light projects; null for none. */
  cookie: CookieSlot | null = null;
  /** Photometric profile that scales the light; null for none. */
  profile: CookieSlot | null = null;
  /** Layers of the objects that cast shadows by this light, as bits. */
  layers = 1;

  // fields below: set in each frame, when maps are assigned
  /** Whether the light has a map that can be sampled. */
  hasShadow = false;
  /** Record of the light's mask, counted from the frame's first mask; -1 for none. */
  record = -1;

  // fields below: set by `plan`, for each draw of the map
  /** Space that the map covers (world space, m), see `Reach`. */
  readonly reach = makeReach();
  /** Faces with a drawn part, as bits. */
  drawnFaces = 63;

  /** Proxy of the light's shadow object: inherits its settings, receives three's changes. */
  private readonly shadowProxy: PrivateLightShadow;
  /** Proxy of the light whose `distance` is 0: three would use an infinite distance as the camera's far plane. */
  private readonly endless: ShadowLight;
  /** The light's own shadow camera, at the position that three would set. */
  private placedCamera: Camera | null = null;
  /** Values of `matrix`, `near` and `far` at the last `follow`, to see whether they changed. */
  private readonly previousCamera = new Float64Array(18);
  /** Radius (texels) and samples of the blur at the last `follow`. */
  private readonly blur = new Float64Array(2);

  /** @param cascades - number of a directional light's maps, that of its whole shadow camera included */
  constructor(
    readonly light: ShadowLight,
    cascades = 1,
  ) {
    this.isCube = light.isPointLight === true;
    const shadow = light.shadow as unknown as PrivateLightShadow;
    this.shadow = shadow;
    this.shadowProxy = standInOf(shadow, Object.prototype);
    this.endless = Object.defineProperty(standInOf(light, Object3D.prototype), 'distance', { value: 0 });
    const camera = shadow.camera.clone();
    // three calls this before it draws the first map, so the host may not have called it
    (camera as unknown as ShadowCamera).updateProjectionMatrix();
    this.define('camera', camera);
    this.define('matrix', this.matrix);
    this.define(SHADOW_FRUSTUM, new Frustum());
    this.faces = this.isCube ? makeCubeFaces() : [new ShadowFace(camera)];
    this.cascades = Math.max(0, cascades - 1);
    this.side = cascades > 1 ? 2 : 1;
    this.fits = new Float64Array(4 * this.cascades);
    // the map of the whole shadow camera is the last
    for (let i = 0; i < this.cascades; i++) this.faces.splice(i, 0, new ShadowFace(cascadeCamera()));
  }

  /** Width of a face in the light's settings (texels). */
  get wantedWidth(): number {
    return Math.max(1, Math.round(this.light.shadow.mapSize.x));
  }

  /** Height of a face in the light's settings (texels). */
  get wantedHeight(): number {
    return Math.max(1, Math.round(this.isCube ? this.light.shadow.mapSize.x : this.light.shadow.mapSize.y));
  }

  /** Stores the scene that the light is in; marks the map as stale if it is another scene. */
  enter(root: Object3D): void {
    if (this.root !== root) this.map.change();
    this.root = root;
  }

  /** Sets the layers of the casters, as bits. */
  setLayers(layers: number): void {
    if (this.layers !== layers) this.map.change();
    this.layers = layers;
  }

  /**
   * Updates cameras by the light and its settings; marks the map as stale if it then shows something else.
   * @param camera - camera of the picture
   * @param blurs - whether the map is blurred after its draw, as variance shadow maps are. Default false
   */
  follow(reversedDepth: boolean, camera: Camera, blurs = false): void {
    const { radius, blurSamples } = this.shadow;
    if (blurs && (radius !== this.blur[0] || blurSamples !== this.blur[1])) this.map.change();
    this.blur[0] = radius;
    this.blur[1] = blurSamples;
    if (this.isCube) this.followPoint(reversedDepth);
    else this.followMap(reversedDepth);
    const refitted = this.cascades > 0 && this.fit(camera);
    const { previousCamera, matrix } = this;
    let same = !refitted && previousCamera[16] === this.near && previousCamera[17] === this.far;
    for (let i = 0; i < 16; i++) {
      if (previousCamera[i] === matrix.elements[i]) continue;
      previousCamera[i] = matrix.elements[i];
      same = false;
    }
    previousCamera[16] = this.near;
    previousCamera[17] = this.far;
    if (same && this.placedCamera === this.shadow.camera) return;
    placeShadowCamera(this.light, this.shadowProxy, this.far, reversedDepth);
    this.placedCamera = this.shadow.camera;
    if (same) return;
    this.map.change();
    if (this.isCube && this.placement.faceWidth > 0) this.aimFaces();
  }

  /** True when one of the maps may show something of a sphere (world space, m). */
  reaches(x: number, y: number, z: number, radius: number): boolean {
    if (radius === Infinity) return true;
    if (!this.isCube) return this.faces.some(({ planes }) => !sphereOutsidePlanes(planes, x, y, z, radius));
    // the map reaches as far as the range; without a range, to the corners of the cube of far planes
    const e = this.matrix.elements;
    const reach = radius + this.far * (this.range < Infinity ? 1 : Math.sqrt(3));
    const dx = x + e[12];
    const dy = y + e[13];
    const dz = z + e[14];
    return dx * dx + dy * dy + dz * dz <= reach * reach;
  }

  /** Distance beyond which the light lights nothing (m); Infinity when it has no range. */
  get range(): number {
    return rangeOf((this.light as PointLight).distance) || Infinity;
  }

  /** True when some of a box (in the form of `casterBox`) is within the range of the light. */
  reachesBox(box: Float64Array): boolean {
    return !isBeyond(this.reach, box, 0);
  }

  /** Tangent of half the angle that a face of a cube shows, its border included. */
  get widening(): number {
    const { faceWidth, border } = this.placement;
    return (faceWidth + 2 * border) / faceWidth;
  }

  /** Radius of the filter (texels of a map of the wanted size); for a cube limited to the border. */
  get filterRadius(): number {
    const { radius } = this.shadow;
    if (!this.isCube) return radius;
    const most = ((LARGEST_BORDER - 0.5) / FARTHEST) * (this.wantedWidth / this.placement.faceWidth);
    return Math.max(-most, Math.min(most, radius));
  }

  /**
   * Offset along a surface's normal at which its shadow is sampled (m). Grows in a map of reduced detail, by half the growth of
   * a texel at the distance that `sufficientDetail` uses.
   */
  get normalBias(): number {
    const { detail, isCube, wantedWidth, shadow } = this;
    const { level } = detail;
    if (level === 0) return shadow.normalBias;
    const scale = isCube ? 1 : this.shadowProxy.camera.projectionMatrix.elements[0];
    return shadow.normalBias + (MATTERING_RANGE * this.range * (2 ** level - 1)) / (scale * wantedWidth);
  }

  /** Whether a point light has moved since its map was drawn, and the map is not redrawn. */
  get hasLeftMap(): boolean {
    const map = this.matrix.elements;
    const light = this.light.matrixWorld.elements;
    if (!this.isCube || !this.hasShadow) return false;
    return map[12] !== -light[12] || map[13] !== -light[13] || map[14] !== -light[14];
  }

  /** Whether depths of 16 bits are too coarse for the map. */
  get needsFineDepth(): boolean {
    const { near, far, isCube, shadowProxy, wantedWidth } = this;
    const camera = shadowProxy.camera as unknown as ShadowCamera;
    const scale = isCube ? 1 : camera.projectionMatrix.elements[0];
    const isPerspective = isCube || camera.isPerspectiveCamera === true;
    return needsFineDepth(near, far, scale, wantedWidth, this.shadow.bias, isPerspective);
  }

  /** Border round a face of a cube that the filter may read (texels), a power of two. */
  borderOf(faceWidth: number): number {
    if (!this.isCube) return 0;
    const reach = Math.abs(this.shadow.radius * faceWidth) / this.wantedWidth || 0;
    return 2 ** Math.ceil(Math.log2(Math.max(1, Math.min(FARTHEST * reach + 0.5, LARGEST_BORDER))));
  }

  /** Places the faces in the region that the atlas has given to the map. */
  placed(): void {
    const { region, faceWidth, faceHeight, border } = this.placement;
    const width = faceWidth + 2 * border;
    const height = faceHeight + 2 * border;
    this.faces.forEach((face, i) => {
      const columns = this.isCube ? 3 : this.side;
      face.x = region!.x + (i % columns) * width;
      face.y = region!.y + Math.floor(i / columns) * height;
      face.width = width;
      face.height = height;
    });
    if (this.isCube) this.aimFaces();
  }

  /**
   * Plans to draw the map in this frame, all of it or only the visible part of each face.
   * @returns texels drawn to
   */
  plan(isPartial: boolean): number {
    let texels = 0;
    this.map.plan(isPartial);
    this.drawnFaces = 0;
    setReach(this.reach, this.faces[0].camera.matrixWorld.elements, this.range, this.widening, 0);
    this.faces.forEach((face, i) => {
      face.plan(isPartial);
      texels += face.texels;
      if (face.texels > 0) this.drawnFaces |= 1 << i;
    });
    return texels;
  }

  private followMap(reversedDepth: boolean): void {
    const { light, shadowProxy } = this;
    const camera = shadowProxy.camera as unknown as ShadowCamera;
    const host = light.shadow.camera as unknown as ShadowCamera;
    let changed = camera.reversedDepth !== reversedDepth;
    setReversedDepth(camera, reversedDepth);
    for (const name of CAMERA_NUMBERS) {
      if (camera[name] === host[name]) continue;
      camera[name] = host[name];
      changed = true;
    }
    const far = (light.isSpotLight === true && rangeOf((light as SpotLight).distance)) || host.far;
    if (camera.far !== far) {
      camera.far = far;
      changed = true;
    }
    if (changed) camera.updateProjectionMatrix();
    shadowProxy.updateMatrices(far === host.far ? this.endless : light);
    this.near = camera.near;
    this.far = camera.far;
    this.faces[this.cascades].update();
  }

  /** Fits the cascades to the space that the camera sees. @returns whether that changed them */
  private fit(camera: Camera): boolean {
    const { cascades, fits, faces } = this;
    const whole = this.shadowProxy.camera as unknown as OrthographicCamera;
    const { x, y } = this.light.shadow.mapSize;
    let changed = false;
    for (let i = 0; i < cascades; i++) {
      fitCascade(faces[i], whole, camera, cascades - i, x, y, fitted);
      for (let k = 0; k < 4; k++) {
        changed ||= fits[i * 4 + k] !== fitted[k];
        fits[i * 4 + k] = fitted[k];
      }
    }
    return changed;
  }

  private followPoint(reversedDepth: boolean): void {
    const { light, matrix } = this;
    const host = light.shadow.camera as unknown as ShadowCamera;
    this.near = host.near;
    this.far = rangeOf((light as PointLight).distance) || host.far;
    position.setFromMatrixPosition(light.matrixWorld);
    matrix.makeTranslation(-position.x, -position.y, -position.z);
    for (const face of this.faces) setReversedDepth(face.camera, reversedDepth);
  }

  private aimFaces(): void {
    const { elements } = this.matrix;
    position.set(-elements[12], -elements[13], -elements[14]);
    for (let i = 0; i < 6; i++) aimCubeFace(this.faces[i], i, position, this.near, this.far, this.widening);
  }

  private define(name: string, value: unknown): void {
    Object.defineProperty(this.shadowProxy, name, { value, writable: true, configurable: true, enumerable: true });
  }
}
