import {
  type Camera,
  Frustum,
  type LightShadow,
  type Object3D,
  Matrix4,
  OrthographicCamera,
  type PerspectiveCamera,
  type PointLight,
  type DirectionalLight,
  type SpotLight,
  Vector3,
} from 'three';
import { rangeOf } from '../../../lights/lightRange';
import { sphereOutsidePlanes } from '../../../lights/sphereOutsidePlanes';
import { fitCascade } from './fitCascade';
import { placeShadowCamera } from './placeShadowCamera';
import { aimCubeFace, makeCubeFaces, ShadowFace } from './ShadowFace';
import type { CookieSlot } from './CookieSlot';
import type { AtlasTenant } from '../atlas/TileAtlas';
import { isBeyond, makeReach, setReach } from './reach';
import { REACH } from './spareHalvings';
import { needsFineDepth } from './fineDepth';
import type { Tile } from '../atlas/TilePacker';

/** Lights that three lets cast shadows. */
export type ShadowLight = (PointLight | SpotLight | DirectionalLight) & {
  isPointLight?: boolean;
  isSpotLight?: boolean;
};

type ShadowCamera = PerspectiveCamera & OrthographicCamera & { _reversedDepth: boolean };
/** Three's, with what is not in its types. */
export type OwnShadow = LightShadow & { updateMatrices(light: ShadowLight): void; _frustum: Frustum };

/** How far a sample of a filter lies across a face at most (radii): at a corner, by the plane's slant. */
const FARTHEST = 1.17;
/** Texels; as a power of two it takes three bits of a mask. */
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
 * The shadow map of one light: its private cameras, where its tile lies, and whether that still holds. What three would
 * change of the light's own shadow (camera, matrix) is changed on a stand-in that inherits its settings, and then left as three
 * would leave it.
 */
export class ShadowSlot implements AtlasTenant {
  readonly isCube: boolean;
  /** The light's own, of which only what three changes too is changed. */
  readonly shadow: LightShadow;
  /** The scene in which it was last lit. */
  root: Object3D | null = null;
  readonly faces: ShadowFace[];
  /** Maps of what is near, before that of the whole. */
  readonly cascades: number;
  readonly side: number;
  /** How coordinates of the whole map become those of each: scale, shift of x; of y. */
  readonly fits: Float64Array;
  /** World space to the map, 0 to 1, and depth; of a point light: to what leads from the light to there. */
  readonly matrix = new Matrix4();
  /** Nearest and farthest of the map's cameras (m). */
  near = 0;
  far = 0;
  /** The place in the atlas, of all faces together. */
  tile: Tile | null = null;
  /** Texels a side of a face that the tile was made for. */
  faceWidth = 0;
  faceHeight = 0;
  /** Texels round each face, of a cube. */
  border = 0;
  /** How often the size that the light asks for is halved, since no picture shows more; and how often it is to be. */
  excess = 0;
  spare = 0;
  /** Frames for which it could have been more often, and the least that it could. */
  patience = 0;
  least = 0;
  /** How often that is halved again, since the atlas is full. */
  halvings = 0;
  /** Share of the picture that the light covers. */
  coverage = 1;
  /** Something in reach changed since the tile was drawn. */
  dirty = true;
  /** The frame in which that was last so. */
  changed = 0;
  /** The tile holds a map. */
  drawn = false;
  /** It holds that only where it could be seen. */
  isPartial = false;
  /** Bounds of its depths are known, see `ShadowBounds`. */
  isBounded = false;
  /** There has been a map: if its tile was lost it is drawn anew, whatever its updates. */
  hadMap = false;
  /** Frame in which the light was last lit. */
  used = 0;
  /** Layers of the casters. */
  layers = 1;
  /** The light casts shadows. */
  casts = false;
  /** It does in this frame. */
  shows = false;
  /** The image that it throws. */
  cookie: CookieSlot | null = null;
  /** Place of its mask record in the frame, -1 for none. */
  record = -1;
  /** What its faces look at, once `draws` is called. */
  readonly reach = makeReach();
  /** The faces that draw anything, as bits. */
  drawnFaces = 63;
  private readonly own: OwnShadow;
  /** The light without a range: three would take one that is infinite for the camera's far plane. */
  private readonly endless: ShadowLight;
  /** The light's camera, once it is where three would put it. */
  private placed: Camera | null = null;
  private readonly before = new Float64Array(18);
  /** Radius and samples of the blur that it has. */
  private readonly blur = new Float64Array(2);

  /** @param cascades maps of a directional light, the whole one included */
  constructor(
    readonly light: ShadowLight,
    cascades = 1,
  ) {
    this.isCube = light.isPointLight === true;
    const shadow = light.shadow as unknown as OwnShadow;
    this.shadow = shadow;
    this.own = Object.create(shadow) as OwnShadow;
    this.endless = Object.create(light, { distance: { value: 0 } }) as ShadowLight;
    const camera = shadow.camera.clone();
    // the host need not have done so: three does it with the first map
    (camera as unknown as ShadowCamera).updateProjectionMatrix();
    this.define('camera', camera);
    this.define('matrix', this.matrix);
    this.define('_frustum', new Frustum());
    this.faces = this.isCube ? makeCubeFaces() : [new ShadowFace(camera)];
    this.cascades = Math.max(0, cascades - 1);
    this.side = cascades > 1 ? 2 : 1;
    this.fits = new Float64Array(4 * this.cascades);
    // the whole map is the last
    for (let i = 0; i < this.cascades; i++) this.faces.splice(i, 0, new ShadowFace(cascadeCamera()));
  }

  /** Texels a side that the light's map has by its own settings. */
  get wantedWidth(): number {
    return Math.max(1, Math.round(this.light.shadow.mapSize.x));
  }
  get wantedHeight(): number {
    return Math.max(1, Math.round(this.isCube ? this.light.shadow.mapSize.x : this.light.shadow.mapSize.y));
  }

  /** The light is lit in a scene; another one casts other shadows. */
  enter(root: Object3D): void {
    if (this.root !== root) this.dirty = true;
    this.root = root;
  }

  /**
   * Follows the light and its settings; the slot is dirty when its view changed.
   * @param blurs its map is blurred once it is drawn, as variance shadow maps are. Default false
   */
  follow(reversedDepth: boolean, view: Camera, blurs = false): void {
    const { radius, blurSamples } = this.shadow;
    if (blurs && (radius !== this.blur[0] || blurSamples !== this.blur[1])) this.dirty = true;
    this.blur[0] = radius;
    this.blur[1] = blurSamples;
    if (this.isCube) this.followPoint(reversedDepth);
    else this.followMap(reversedDepth);
    const refitted = this.cascades > 0 && this.fit(view);
    const { before, matrix } = this;
    let same = !refitted && before[16] === this.near && before[17] === this.far;
    for (let i = 0; i < 16; i++) {
      if (before[i] === matrix.elements[i]) continue;
      before[i] = matrix.elements[i];
      same = false;
    }
    before[16] = this.near;
    before[17] = this.far;
    if (same && this.placed === this.shadow.camera) return;
    placeShadowCamera(this.light, this.own, this.far, reversedDepth);
    this.placed = this.shadow.camera;
    if (same) return;
    this.dirty = true;
    if (this.isCube && this.faceWidth > 0) this.aimFaces();
  }

  /** True when a sphere (world space, m) may be in one of the maps. */
  reaches(x: number, y: number, z: number, radius: number): boolean {
    if (radius === Infinity) return true;
    if (!this.isCube) return this.faces.some(({ planes }) => !sphereOutsidePlanes(planes, x, y, z, radius));
    // beyond a range nothing is lit; without one, the corners of the cube of far planes count
    const e = this.matrix.elements;
    const reach = radius + this.far * (this.range < Infinity ? 1 : Math.sqrt(3));
    const dx = x + e[12];
    const dy = y + e[13];
    const dz = z + e[14];
    return dx * dx + dy * dy + dz * dz <= reach * reach;
  }

  /** Beyond this nothing is lit (m), Infinity where it has no range. */
  get range(): number {
    return rangeOf((this.light as PointLight).distance) || Infinity;
  }

  /** False when no part of a box (as `casterBox` gives it) is within the range of the light. */
  reachesBox(box: Float64Array): boolean {
    return !isBeyond(this.reach, box, 0);
  }

  /** Tangent of half the angle that a face of a cube sees: what lies beside it too, as wide as its border. */
  get widening(): number {
    return (this.faceWidth + 2 * this.border) / this.faceWidth;
  }

  /** Radius of the filter (texels of a map of the size that the light asks for); of a cube no more than its border holds. */
  get filterRadius(): number {
    const { radius } = this.shadow;
    if (!this.isCube) return radius;
    const most = ((LARGEST_BORDER - 0.5) / FARTHEST) * (this.wantedWidth / this.faceWidth);
    return Math.max(-most, Math.min(most, radius));
  }

  /**
   * How far from a surface its shadow is looked up, along its normal (m): a map that is halved since pictures show no more needs
   * more of that, by half of what a texel is wider there where `spareHalvings` looks.
   */
  get normalBias(): number {
    const { excess, isCube, wantedWidth, shadow } = this;
    if (excess === 0) return shadow.normalBias;
    const scale = isCube ? 1 : this.own.camera.projectionMatrix.elements[0];
    return shadow.normalBias + (REACH * this.range * (2 ** excess - 1)) / (scale * wantedWidth);
  }

  /** Whether a point light is elsewhere than its map is of, since nothing has it drawn anew. */
  get isLeft(): boolean {
    const map = this.matrix.elements;
    const light = this.light.matrixWorld.elements;
    if (!this.isCube || !this.shows) return false;
    return map[12] !== -light[12] || map[13] !== -light[13] || map[14] !== -light[14];
  }

  /** Whether depths of 16 bits are too coarse for it. */
  get needsFineDepth(): boolean {
    const { near, far, isCube, own, wantedWidth } = this;
    const camera = own.camera as unknown as ShadowCamera;
    const scale = isCube ? 1 : camera.projectionMatrix.elements[0];
    const isPerspective = isCube || camera.isPerspectiveCamera === true;
    return needsFineDepth(near, far, scale, wantedWidth, this.shadow.bias, isPerspective);
  }

  /** Texels round a face of a cube that its filter reaches at most, a power of two. */
  borderOf(faceWidth: number): number {
    if (!this.isCube) return 0;
    const reach = Math.abs(this.shadow.radius * faceWidth) / this.wantedWidth || 0;
    return 2 ** Math.ceil(Math.log2(Math.max(1, Math.min(FARTHEST * reach + 0.5, LARGEST_BORDER))));
  }

  /** Takes a place in the atlas; the map is to be drawn anew. */
  place(tile: Tile, faceWidth: number, faceHeight: number): void {
    this.tile = tile;
    this.faceWidth = faceWidth;
    this.faceHeight = faceHeight;
    this.dirty = true;
    this.drawn = false;
    this.border = this.borderOf(faceWidth);
    const width = faceWidth + 2 * this.border;
    const height = faceHeight + 2 * this.border;
    this.faces.forEach((face, i) => {
      const columns = this.isCube ? 3 : this.side;
      face.x = tile.x + (i % columns) * width;
      face.y = tile.y + Math.floor(i / columns) * height;
      face.width = width;
      face.height = height;
    });
    if (this.isCube) this.aimFaces();
  }

  /** Has its faces draw what can be seen alone, or all. @returns texels that they draw to */
  draws(isPart: boolean): number {
    let texels = 0;
    this.isPartial = isPart;
    this.drawnFaces = 0;
    setReach(this.reach, this.faces[0].camera.matrixWorld.elements, this.range, this.widening, 0);
    this.faces.forEach((face, i) => {
      face.draws(!isPart);
      texels += face.texels;
      if (face.texels > 0) this.drawnFaces |= 1 << i;
    });
    return texels;
  }

  private followMap(reversedDepth: boolean): void {
    const { light, own } = this;
    const camera = own.camera as unknown as ShadowCamera;
    const host = light.shadow.camera as unknown as ShadowCamera;
    let changed = camera._reversedDepth !== reversedDepth;
    camera._reversedDepth = reversedDepth;
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
    own.updateMatrices(far === host.far ? this.endless : light);
    this.near = camera.near;
    this.far = camera.far;
    this.faces[this.cascades].update();
  }

  /** Fits the nearer maps round what is seen. @returns whether that changed them */
  private fit(view: Camera): boolean {
    const { cascades, fits, faces } = this;
    const whole = this.own.camera as unknown as OrthographicCamera;
    const { x, y } = this.light.shadow.mapSize;
    let changed = false;
    for (let i = 0; i < cascades; i++) {
      fitCascade(faces[i], whole, view, cascades - i, x, y, fitted);
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
    for (const face of this.faces) (face.camera as unknown as ShadowCamera)._reversedDepth = reversedDepth;
  }

  private aimFaces(): void {
    const { elements } = this.matrix;
    position.set(-elements[12], -elements[13], -elements[14]);
    for (let i = 0; i < 6; i++) aimCubeFace(this.faces[i], i, position, this.near, this.far, this.widening);
  }

  private define(name: string, value: unknown): void {
    Object.defineProperty(this.own, name, { value, writable: true, configurable: true, enumerable: true });
  }
}
