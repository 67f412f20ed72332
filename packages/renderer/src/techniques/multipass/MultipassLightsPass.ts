import {
  type Material,
  DepthStencilFormat,
  DepthTexture,
  FloatType,
  HalfFloatType,
  NearestFilter,
  NoToneMapping,
  Sphere,
  Vector3,
  Vector4,
  WebGLRenderTarget,
  type BufferGeometry,
  Object3D,
} from 'three';
import { fitTarget } from '../../gpu/fitTarget';
import { blendsFloats } from '../../gpu/checkDevice';
import type { FieldDraws } from '../../frame/FieldDraws';
import type { AccumulatedLight } from '../../frame/AccumulatedLight';
import type { Frame } from '../../frame/Frame';
import { targetBytes } from '../../gpu/targetBytes';
import * as chunks from './chunks';
import { coneIntersectsSphere } from '../../lights/cones';
import { projectedSphereBounds } from '../../lights/projection';
import { additiveTwin, baseTwin, fieldTwin, lightMark } from './multipassTwins';
import type { RenderItem } from '../../frame/RenderItem';
import type { Pass } from '../../frame/Pass';
import { isDrawnAsCanvas } from '../../three/drawnAsCanvas';
import { isDepthReversed, setScissor, testScissor, unmaskDepth, unmaskStencil } from '../../three/state';

const rectangle = new Float64Array(4);
const scissor = new Vector4();
const centre = new Vector3();
const NO_MARK = new Int32Array(1);
const { onBeforeRender } = Object3D.prototype;
/** Share of the picture from which on a light with a range is drawn together with ambient light, over all objects. */
const FIRST_SHARE = 0.25;

/**
 * Multipass lighting: a first pass draws ambient, environment and emissive light with one large light; then each other light is
 * added by its own draw of the objects in its range, inside its volume's rectangle on screen. Sums are 32-bit floats where the
 * device blends them (EXT_float_blend) and the host's target has one sample; else half floats.
 * @see thesis 2.2.1.3 and 3.2.3.1
 */
export class MultipassLightsPass implements Pass {
  readonly name = 'multipass lights';
  readonly microShaders = { ...chunks };
  readonly reads = [] as const;
  readonly writes = ['accumulated-light'] as const;
  private target: WebGLRenderTarget | null = null;
  private fogged = true;
  /** Resource `accumulated-light`; a new object when its target or `hasFog` changes. */
  private result: AccumulatedLight | null = null;
  private readonly items: RenderItem[] = [];
  /** View-space sphere of each item, 4 numbers; radius Infinity if unknown. */
  private spheres = new Float64Array(256);
  private slot: 0 | 1 = 0;
  /** Objects whose additive program is linked, with the material that the program is for. */
  private readonly compiled = new WeakMap<Object3D, Material>();

  get bytes(): number {
    return this.target === null ? 0 : targetBytes(this.target);
  }

  render(frame: Frame): void {
    this.fogged = frame.target !== null && !isDrawnAsCanvas(frame.target);
    this.items.length = 0;
    // kept for an enclosing frame, one of whose callbacks may draw this frame
    const mark = lightMark.value;
    try {
      this.prepareTarget(frame);
      this.drawLights(frame);
    } finally {
      lightMark.value = mark;
    }
    const { texture, depthTexture, samples } = this.target!;
    if (samples > 0) frame.resolve(this.target!);
    if (this.result?.texture !== texture || this.result.hasFog !== this.fogged)
      this.result = { texture, depth: depthTexture!, hasFog: this.fogged };
    frame.resources.put('accumulated-light', this.result);
  }

  dispose(): void {
    this.target?.depthTexture?.dispose();
    this.target?.dispose();
    this.target = this.result = null;
  }

  private drawLights(frame: Frame): void {
    const { items } = this;
    const base = baseTwin(frame.view, this.fogged);
    const { opaque } = frame.queue;
    const first = this.firstLight(frame);
    frame.uniforms.farol_lightIndex.value = first;
    // by index: an iterator would allocate until the engine compiles the loop
    for (let i = 0; i < opaque.length; i++) {
      const item = opaque[i];
      // skips lines: where segments meet, one would show ambient light and another the added lights
      if (item.route !== 'split' || 'isLine' in item.object || !this.sums(item.material, frame)) continue;
      frame.drawTwin(item, base);
      item.drawn = true;
      items.push(item);
    }
    if (items.length === 0) return;
    this.compile(frame);
    this.findSpheres(frame);
    const { lights } = frame;
    for (let i = first === 0 ? 1 : 0; i < lights.directional + lights.unbounded; i++) this.drawLight(frame, i, -1);
    const { webgl } = frame;
    for (let k = 0; k < lights.bounded; k++) {
      if (lights.firstBounded + k === first || !this.cutTo(frame, lights.order[k])) continue;
      setScissor(webgl, scissor);
      testScissor(webgl, true);
      this.drawLight(frame, lights.firstBounded + k, lights.order[k]);
    }
    testScissor(webgl, false);
    if (frame.fields !== null) this.drawFields(frame, frame.fields);
  }

  /**
   * Record of the light that is drawn together with ambient light: one without a range, else the one with the largest rectangle
   * on screen; -1 if that is below `FIRST_SHARE`.
   */
  private firstLight(frame: Frame): number {
    const { lights, view } = frame;
    if (view !== 'final' && view !== 'grid') return -1; // other views show no ambient light
    if (lights.directional + lights.unbounded > 0) return 0;
    let first = -1;
    let largest = FIRST_SHARE * frame.width * frame.height;
    for (let k = 0; k < lights.bounded; k++) {
      if (!this.cutTo(frame, lights.order[k]) || scissor.z * scissor.w < largest) continue;
      first = lights.firstBounded + k;
      largest = scissor.z * scissor.w;
    }
    return first;
  }

  /** Adds the lights of all light fields in one draw, in which each pixel loops over its tile's list: they are thousands. */
  private drawFields(frame: Frame, fields: FieldDraws): void {
    fields.makeFieldTiles(frame);
    frame.bind(this.target!);
    if (lightMark.value === 255) this.unmark(frame);
    else lightMark.value++;
    const kind = fieldTwin(frame.view, this.fogged);
    // tiles begin at the corner of this pass's target, not at the host's viewport
    const offset = frame.uniforms.farol_offset.value;
    offset.set(0, 0);
    for (let i = this.items.length - 1; i >= 0; i--) frame.drawTwin(this.items[i], kind);
    offset.set(frame.viewport.x, frame.viewport.y);
  }

  /** Whether three would tone map, fog and dither the material as the output pass treats all pixels. */
  private sums(material: Material, frame: Frame): boolean {
    if (frame.hasMedia && (material as Material & { fog?: boolean }).fog === false) return false;
    if (this.fogged) return true;
    if (material.dithering) return false;
    // the output pass computes fog from depth, which is too coarse here
    if (frame.storesDistance && frame.scene.fog) return false;
    if (!material.toneMapped && frame.webgl.toneMapping !== NoToneMapping) return false;
    return (material as Material & { fog?: boolean }).fog !== false || !frame.scene.fog;
  }

  private prepareTarget(frame: Frame): void {
    const { width, height, gl, samples } = frame;
    if (this.target !== null && this.target.samples !== samples) this.dispose();
    this.target ??= new WebGLRenderTarget(1, 1, {
      samples,
      type: samples === 0 && blendsFloats(gl) ? FloatType : HalfFloatType,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
      stencilBuffer: true,
      depthTexture: depthAndStencil(),
    });
    fitTarget(this.target, width, height);
    frame.bind(this.target);
    frame.clear(1, false);
    // clears both at once: clearing one of depth and stencil must preserve the other, which is slow
    lightMark.value = 1;
    unmaskDepth(frame.webgl);
    unmaskStencil(frame.webgl);
    gl.clearBufferfi(gl.DEPTH_STENCIL, 0, isDepthReversed(frame.webgl) ? 0 : 1, 0);
  }

  /** Clears the marks of lights in the stencil buffer. */
  private unmark(frame: Frame): void {
    lightMark.value = 1;
    unmaskStencil(frame.webgl);
    frame.gl.clearBufferiv(frame.gl.STENCIL, 0, NO_MARK);
  }

  /** Draws new objects with the additive twin and an empty scissor, so that the first light on an object compiles nothing. */
  private compile(frame: Frame): void {
    const { webgl } = frame;
    let scissored = false;
    for (let i = 0; i < this.items.length; i++) {
      const item = this.items[i];
      if (this.compiled.get(item.object) === item.material) continue;
      this.compiled.set(item.object, item.material);
      // skips items whose callback may change the target and so the scissor: the light would be added twice
      if (item.object.onBeforeRender !== onBeforeRender) continue;
      if (!scissored) {
        setScissor(webgl, scissor.set(0, 0, 0, 0));
        testScissor(webgl, true);
        scissored = true;
      }
      frame.drawTwin(item, additiveTwin(frame.view, this.slot, this.fogged));
    }
    if (!scissored) return;
    testScissor(webgl, false);
    this.turn();
  }

  /** Switches to the other twin: three sets uniforms, the light among them, only when the material changes. */
  private turn(): void {
    this.slot = this.slot === 0 ? 1 : 0;
  }

  private drawLight(frame: Frame, record: number, bounded: number): void {
    const { lights } = frame;
    frame.uniforms.farol_lightIndex.value = record;
    if (lightMark.value === 255) this.unmark(frame);
    else lightMark.value++;
    const kind = additiveTwin(frame.view, this.slot, this.fogged);
    let drawn = false;
    const { items, spheres: itemSpheres } = this;
    const b = bounded * 4;
    // last object first: of several surfaces at one depth the last is visible, and the mark keeps the light off the others
    for (let i = items.length - 1; i >= 0; i--) {
      if (bounded >= 0 && itemSpheres[i * 4 + 3] !== Infinity) {
        const { spheres, cones } = lights;
        const at = i * 4;
        const dx = itemSpheres[at] - spheres[b];
        const dy = itemSpheres[at + 1] - spheres[b + 1];
        const dz = itemSpheres[at + 2] - spheres[b + 2];
        const reach = itemSpheres[at + 3] + spheres[b + 3];
        if (dx * dx + dy * dy + dz * dz > reach * reach) continue;
        if (cones[b + 3] > -1 && !coneIntersectsSphere(spheres, cones, b, itemSpheres, at)) continue;
      }
      frame.drawTwin(items[i], kind);
      drawn = true;
    }
    // only after a draw: the next light's twin must differ from the one drawn last
    if (drawn) this.turn();
  }

  /** Sets `scissor` to the rectangle of a light. @returns false if it covers no pixel */
  private cutTo(frame: Frame, k: number): boolean {
    const { spheres } = frame.lights;
    const { camera, width, height } = frame;
    if (!projectedSphereBounds(spheres, k * 4, camera.projectionMatrix.elements, rectangle)) return false;
    const x0 = Math.max(0, Math.floor((rectangle[0] * 0.5 + 0.5) * width));
    const y0 = Math.max(0, Math.floor((rectangle[1] * 0.5 + 0.5) * height));
    const x1 = Math.min(width, Math.ceil((rectangle[2] * 0.5 + 0.5) * width));
    const y1 = Math.min(height, Math.ceil((rectangle[3] * 0.5 + 0.5) * height));
    scissor.set(x0, y0, x1 - x0, y1 - y0);
    return x1 > x0 && y1 > y0;
  }

  private findSpheres(frame: Frame): void {
    const { items } = this;
    if (this.spheres.length < items.length * 4) this.spheres = new Float64Array(items.length * 8);
    for (let i = 0; i < items.length; i++) {
      const { object, geometry } = items[i];
      const bound = boundingSphereOf(object, geometry);
      const at = i * 4;
      if (bound === null || !object.frustumCulled) {
        this.spheres[at + 3] = Infinity;
        continue;
      }
      centre.copy(bound.center).applyMatrix4(object.matrixWorld).applyMatrix4(frame.camera.matrixWorldInverse);
      const displacement = items[i].material as {
        displacementMap?: unknown;
        displacementScale?: number;
        displacementBias?: number;
      };
      const more = displacement.displacementMap
        ? Math.abs(displacement.displacementScale ?? 0) + Math.abs(displacement.displacementBias ?? 0)
        : 0;
      this.spheres[at] = centre.x;
      this.spheres[at + 1] = centre.y;
      this.spheres[at + 2] = centre.z;
      this.spheres[at + 3] = (bound.radius + more) * object.matrixWorld.getMaxScaleOnAxis();
    }
  }
}

/** Sphere by which three culls an object, in the object's space. */
function boundingSphereOf(object: Object3D, geometry: BufferGeometry): Sphere | null {
  const own = (object as Object3D & { boundingSphere?: Sphere | null }).boundingSphere;
  return own ?? geometry.boundingSphere;
}

function depthAndStencil(): DepthTexture {
  const texture = new DepthTexture(1, 1, FloatType);
  texture.format = DepthStencilFormat;
  return texture;
}
