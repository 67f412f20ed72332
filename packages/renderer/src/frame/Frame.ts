import {
  type Camera,
  type Color,
  DoubleSide,
  type BufferGeometry,
  type Material,
  Mesh,
  type Object3D,
  type RawShaderMaterial,
  type Scene,
  type ShaderMaterial,
  UnsignedShortType,
  Vector2,
  Vector4,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';
import type { View } from './views';
import type { Fills } from './Fills';
import type { GBuffer } from '../gbuffer/GBuffer';
import { warnOfNaN } from './warnOfNaN';
import { farthestTold, isPlainProjection, needsStoredDistance } from '../gbuffer/depthLimits';
import { gbufferLayout, type GBufferAttachment } from '../gbuffer/gbufferLayout';
import type { FieldDraws } from './FieldDraws';
import type { LightTable } from '../lighting/LightTable';
import type { ReactiveMask } from './ReactiveMask';
import { depthTwin, hasDepthTwin } from '../materials/depthTwin';
import type { ForwardTwins } from '../materials/forwardTwin';
import { setLayers } from '../materials/layersAttribute';
import { plainBack, plainFront, plainWhole } from '../materials/plainTwins';
import { followHostUniforms } from '../materials/hostUniforms';
import { surfacesOf } from '../materials/surfacesOf';
import type { TwinCache } from '../materials/TwinCache';
import type { TwinKind } from '../materials/TwinKind';
import type { MicroShaderRegistry } from '../microshaders';
import { logarithmicFar } from '../gpu/unprojectUniforms';
import type { GeometryGroup, RenderItem } from './RenderItem';
import type { NodeDraws } from '../three/nodes/NodeDraws';
import { hasOwnShader, RenderQueue } from './RenderQueue';
import { ResourceTable } from './Resources';
import type { SharedUniforms } from './sharedUniforms';
import type { TwinAdapter } from './TwinAdapter';
import { directDraw, type DirectDraw } from '../three/directDraw';
import { framebufferHandle, multisampledFramebufferHandle, textureHandle } from '../three/handles';
import {
  bindFramebuffer,
  bindTexture,
  isDepthReversed,
  setViewport,
  unbindTexture,
  unmaskColour,
  unmaskDepth,
} from '../three/state';

type MaterialCallback = (
  r: WebGLRenderer,
  s: Scene,
  c: Camera,
  g: BufferGeometry,
  o: Object3D,
  p: GeometryGroup | null,
) => void;

const TRANSPARENT = new Vector4(0, 0, 0, 0);
const size = new Vector2();

/** A frame as passes and effects see it: scene, target, queue, lights, resources, and how to draw. One a FarolRenderer. */
export class Frame {
  readonly gl: WebGL2RenderingContext;
  readonly queue = new RenderQueue();
  /** Resources that the passes of this frame have handed over so far. */
  readonly resources = new ResourceTable();
  scene!: Scene;
  camera!: Camera;
  /** Camera whose layers select lights and shadow casters: `camera`, or the array of cameras that contains it. */
  seenBy!: Camera;
  view: View = 'final';
  /** The host's render target, null for the canvas. */
  target: WebGLRenderTarget | null = null;
  /** Samples a pixel of the host's target, also while an effect redirects the frame to another target. */
  hostSamples = 0;
  /** Rectangle of the target that is drawn to: x, y, width, height (pixels). */
  readonly viewport = new Vector4();
  /** Width of the viewport (pixels), at least 1. */
  width = 1;
  height = 1;
  /** Bytes that passes have uploaded in this frame. */
  uploadedBytes = 0;
  /** Collects pixels without a usable past. Set in `begin` by an effect that uses earlier frames; else null. */
  reactive: ReactiveMask<Frame> | null = null;
  /** Way in which the technique fills the target that three was kept from clearing; null if three clears. */
  fills: Fills | null = null;
  /** Cube face, and mipmap level, of the target. */
  face = 0;
  level = 0;
  /** Number of shadow maps drawn in this frame. */
  shadowMapsDrawn = 0;
  /**
   * Finds, for each tile of a G-buffer, the lights that light all or none of it; null while no light casts a shadow.
   */
  findTileShadows: ((gbuffer: GBuffer) => void) | null = null;
  /** Draws of light fields; null without light fields in the frame. */
  fields: FieldDraws<Frame> | null = null;
  /** Gives the forward twins of materials with Gouraud shading; null until their code is there. */
  gouraudTwins: () => ForwardTwins | null = () => null;
  /** Makes the object that draws node materials by three; null until its code is loaded. */
  makeNodes: () => NodeDraws | null = () => null;
  /** Adapt the kind of twin that an item is drawn with, in order: each gets the result of the one before. */
  adapters: readonly TwinAdapter[] = [];
  /** Attachments of the G-buffer after those of `gbufferLayout`. */
  gbufferExtras: readonly GBufferAttachment[] = [];
  /** Texels of the lighting buffers of the technique 'inferred' for each pixel, along a side: above 0, at most 1. */
  inferredScale = 1;
  /** Whether depth is too coarse to rebuild positions from. */
  private isDepthCoarse = false;
  /** Whether passes can go by the camera's projection: see `isPlainProjection`. */
  hasPlainProjection = true;
  /** Whether the canvas has depth, and no stencil. */
  private readonly canvasDepthOnly: boolean;
  /** Whether the canvas's colours are multiplied by alpha. */
  readonly premultiplied: boolean;
  private readonly canvasSamples: number;
  /** Whether the host's target has several textures; then no effect replaces the target. */
  several = false;
  private nodes: NodeDraws | null = null;
  /** Whether the frame has node materials whose code is not loaded yet. */
  lacksNodes = false;
  /** Draws one object with one material, inside three's `render`. */
  readonly draw: DirectDraw;

  constructor(
    readonly webgl: WebGLRenderer,
    readonly lights: LightTable,
    readonly twins: TwinCache,
    readonly uniforms: SharedUniforms,
    readonly microshaders: MicroShaderRegistry,
  ) {
    this.gl = webgl.getContext() as WebGL2RenderingContext;
    const attributes = this.gl.getContextAttributes();
    this.canvasDepthOnly = attributes?.stencil === false && attributes.depth !== false;
    this.premultiplied = attributes?.premultipliedAlpha !== false;
    this.draw = directDraw(webgl);
    this.canvasSamples = attributes?.antialias ? 4 : 0;
  }

  /** Location of an attachment of `gbufferExtras` in G-buffers, -1 where the device has no room for it. */
  locationOf(extra: GBufferAttachment): number {
    const index = this.gbufferExtras.indexOf(extra);
    return index < 0 ? -1 : gbufferLayout.length + index;
  }

  /** Whether surfaces store their distance, since depth is too coarse or shifted to rebuild positions from. */
  get storesDistance(): boolean {
    return this.isDepthCoarse || this.queue.farthest === -Infinity;
  }

  /** Samples a pixel of the target: above 0 it is multisampled. */
  get samples(): number {
    return this.target === null ? this.canvasSamples : this.target.samples;
  }

  /** Takes over the host's target, viewport, scene and camera. */
  begin(scene: Object3D, camera: Camera, view: View): void {
    const { webgl } = this;
    this.scene = scene as Scene;
    this.camera = camera;
    this.view = view;
    this.uploadedBytes = 0;
    this.reactive = null;
    this.resources.begin();
    this.nodes?.begin();
    this.lacksNodes = false;
    this.target = webgl.getRenderTarget() as WebGLRenderTarget | null;
    this.hostSamples = this.samples;
    this.face = webgl.getActiveCubeFace();
    this.level = webgl.getActiveMipmapLevel();
    this.several = this.target !== null && this.target.textures.length > 1;
    webgl.getCurrentViewport(this.viewport);
    this.resize();
    const { elements } = camera.projectionMatrix;
    this.hasPlainProjection = isPlainProjection(elements, 'isOrthographicCamera' in camera);
    const reversed = isDepthReversed(webgl);
    const logarithmic = logarithmicFar(camera, webgl);
    this.isDepthCoarse = needsStoredDistance(elements, reversed || logarithmic > 0);
    const coarse = this.target?.depthTexture?.type === UnsignedShortType;
    this.queue.watchFar(camera, farthestTold(elements, reversed, logarithmic, coarse));
    warnOfNaN(camera);
  }

  /** Sets `target` to the buffer that three draws to in place of the canvas when made with an `outputBufferType`. */
  takeOutputBuffer(): void {
    const { webgl } = this;
    if (this.target !== null) return;
    this.target = webgl.getRenderTarget() as WebGLRenderTarget | null;
    if (this.target === null) return;
    webgl.getCurrentViewport(this.viewport);
    this.resize();
  }

  /** Sets `width` and `height` by the viewport. */
  resize(): void {
    const { viewport } = this;
    if (viewport.z < 1 || viewport.w < 1) {
      this.webgl.getDrawingBufferSize(size);
      viewport.set(0, 0, size.x, size.y);
    }
    this.width = Math.max(1, Math.round(viewport.z));
    this.height = Math.max(1, Math.round(viewport.w));
  }

  /**
   * True if the viewport covers the whole target, so that a pass over it writes every pixel; false without a depth
   * buffer.
   */
  ownsTarget(): boolean {
    const { webgl, target, viewport, view } = this;
    if (view !== 'final' || this.level !== 0 || this.samples > 0 || isDepthReversed(webgl)) return false;
    if (target === null) {
      webgl.getDrawingBufferSize(size);
      if (!this.canvasDepthOnly || webgl.getScissorTest()) return false;
    } else {
      size.set(target.width, target.height);
      if (!target.depthBuffer || target.stencilBuffer || target.scissorTest || target.textures.length > 1) return false;
    }
    return viewport.x === 0 && viewport.y === 0 && viewport.z === size.x && viewport.w === size.y;
  }

  /** Binds the host's target for the draws that follow. */
  bindTarget(): void {
    this.webgl.setRenderTarget(this.target, this.face, this.level);
    setViewport(this.webgl, this.viewport);
  }

  /** Binds a target of Farol's own for the draws that follow. */
  bind(target: WebGLRenderTarget): void {
    this.webgl.setRenderTarget(target);
  }

  /** Clears attachments of the bound target to a value and its depth to the farthest, without touching the host's clear colour. */
  clear(attachments: number, depth: boolean, value: Vector4 = TRANSPARENT): void {
    const { gl, webgl } = this;
    unmaskColour(webgl);
    value.toArray(clearColor);
    for (let i = 0; i < attachments; i++) gl.clearBufferfv(gl.COLOR, i, clearColor);
    if (depth) {
      unmaskDepth(webgl);
      farDepth[0] = isDepthReversed(webgl) ? 0 : 1;
      gl.clearBufferfv(gl.DEPTH, 0, farDepth);
    }
  }

  /** Clears one attachment of the bound target to zeros. */
  clearOne(attachment: number): void {
    unmaskColour(this.webgl);
    TRANSPARENT.toArray(clearColor);
    this.gl.clearBufferfv(this.gl.COLOR, attachment, clearColor);
  }

  /**
   * Whether later draws over a multisampled target need depth in each sample, for items that were drawn elsewhere.
   * False if the target has other depth already.
   */
  get wantsSampleDepths(): boolean {
    const { webgl, queue, scene, view } = this;
    if (this.samples === 0 || view !== 'final' || queue.early > 0 || webgl.capabilities.logarithmicDepthBuffer)
      return false;
    const clears = webgl.autoClear || (scene.background as Color | null)?.isColor === true;
    if (!clears || !webgl.autoClearDepth) return false;
    return queue.transparent.length + queue.transmissive.length > 0 || queue.opaque.some(isLeft);
  }

  /** Draws the depth of items that were drawn elsewhere into the samples of the target. */
  drawSampleDepths(): void {
    for (const item of this.queue.opaque) {
      if (item.drawn && item.splits && hasDepthTwin(item.material)) this.drawTwin(item, depthTwin);
    }
  }

  /** Limits the draws that follow to the lower right quarter. */
  quarter(): void {
    const { viewport } = this;
    const width = Math.max(1, viewport.z >> 1);
    const height = Math.max(1, viewport.w >> 1);
    viewport.set(viewport.x + viewport.z - width, viewport.y, width, height);
    this.resize();
  }

  /** Resolves a multisampled target into its textures; depth by one of the samples. */
  resolve(target: WebGLRenderTarget): void {
    const { gl, webgl } = this;
    this.copy(multisampledFramebufferHandle(webgl, target)!, target, gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  }

  /** Updates the texture and mipmaps of three's transmission target, which is bound, after more draws. */
  resolveTransmission(): void {
    const { gl, webgl } = this;
    const target = webgl.getRenderTarget() as WebGLRenderTarget;
    this.copy(multisampledFramebufferHandle(webgl, target)!, target, gl.COLOR_BUFFER_BIT);
    bindTexture(webgl, gl.TEXTURE_2D, textureHandle(webgl, target.texture)!);
    gl.generateMipmap(gl.TEXTURE_2D);
    unbindTexture(webgl);
  }

  /**
   * Copies depth to all of a target, both with a depth texture of the same format.
   * @param x - first pixel of the copied part, with y
   */
  copyDepth(from: WebGLRenderTarget, to: WebGLRenderTarget, x = 0, y = 0): void {
    this.copy(framebufferHandle(this.webgl, from)!, to, this.gl.DEPTH_BUFFER_BIT, x, y);
  }

  /** @param x - first pixel of the copied part of `from`, with y */
  private copy(from: WebGLFramebuffer, to: WebGLRenderTarget, bits: number, x = 0, y = 0): void {
    const { gl, webgl } = this;
    const { width, height } = to;
    const written = framebufferHandle(webgl, to)!;
    bindFramebuffer(webgl, gl.READ_FRAMEBUFFER, from);
    bindFramebuffer(webgl, gl.DRAW_FRAMEBUFFER, written);
    gl.blitFramebuffer(x, y, x + width, y + height, 0, 0, width, height, bits, gl.NEAREST);
    bindFramebuffer(webgl, gl.READ_FRAMEBUFFER, written);
  }

  /** Kind of twin for an item after the adapters of effects. */
  private adapted(kind: TwinKind, item: RenderItem): TwinKind {
    const { adapters } = this;
    for (let i = 0; i < adapters.length; i++) kind = adapters[i].adapt(kind, item);
    return kind;
  }

  /** Draws an item with a twin of its material, if the material can have one. */
  drawTwin(item: RenderItem, kind: TwinKind): void {
    if (item.nodes) return;
    if (item.ownShader) followHostUniforms(this.webgl, item.material);
    this.drawItem(item, this.twins.get(item.material, this.adapted(kind, item)));
  }

  /** Draws an item forward: a lit one by a twin, others by the host's material. */
  drawForward(item: RenderItem, twins: ForwardTwins): void {
    const { material, lit } = item;
    if (item.nodes) this.drawNodes(item);
    else if (item.shadowMask) this.drawTwin(item, this.queue.shadowMasks!.twin);
    else if (material.transparent && material.side === DoubleSide && !material.forceSinglePass) {
      this.drawTwin(item, lit ? twins.back : plainBack);
      this.drawTwin(item, lit ? twins.front : plainFront);
    } else if (lit) this.drawTwin(item, twins.whole);
    else if (surfacesOf(material) || this.adapted(plainWhole, item) !== plainWhole) this.drawTwin(item, plainWhole);
    else this.drawItem(item, material);
  }

  /** Draws an item of a node material by three itself, unless it is drawn already. */
  drawNodes(item: RenderItem): void {
    if (item.drawn) return;
    this.nodes ??= this.makeNodes();
    if (this.nodes === null) this.lacksNodes = true;
    else this.nodes.draw(this, item);
  }

  /** Compiles the program of one of Farol's own meshes now, not in a later frame, by a draw of nothing. */
  compileMesh(mesh: Mesh, material: RawShaderMaterial | ShaderMaterial): void {
    const { drawRange } = mesh.geometry;
    const { count } = drawRange;
    drawRange.count = 0;
    try {
      this.drawMesh(mesh, material);
    } finally {
      // meshes of other renderers have the same geometry
      drawRange.count = count;
    }
  }

  /** Draws one of Farol's own meshes; to the first texture of a host's target with several. */
  drawMesh(mesh: Mesh, material: RawShaderMaterial | ShaderMaterial): void {
    const several = this.drawsToSeveral;
    if (several) this.setDrawBuffers(1);
    try {
      this.draw(this.camera, this.scene, mesh.geometry, material, mesh, null);
    } finally {
      if (several) this.setDrawBuffers(this.target!.textures.length);
    }
  }

  /** Whether the host's target is bound and has several textures. */
  private get drawsToSeveral(): boolean {
    return this.several && this.webgl.getRenderTarget() === this.target;
  }

  /** Limits draws to the first `count` textures of the bound target; WebGL refuses a shader that writes fewer. */
  private setDrawBuffers(count: number): void {
    const { gl } = this;
    gl.drawBuffers((drawBuffers[count] ??= Array.from({ length: count }, (_, i) => gl.COLOR_ATTACHMENT0 + i)));
  }

  /** Draws an item with a material, and calls the host's `onBeforeRender` and `onAfterRender` of both. */
  drawItem(item: RenderItem, material: Material): void {
    const { object, geometry, group } = item;
    const { webgl, scene, camera } = this;
    const source = item.material as ShaderMaterial;
    (object.onBeforeRender as unknown as MaterialCallback)(webgl, scene, camera, geometry, source as never, group);
    if (this.queue.layers !== 0) setLayers(this.gl, object.layers.mask);
    object.modelViewMatrix.multiplyMatrices(camera.matrixWorldInverse, object.matrixWorld);
    object.normalMatrix.getNormalMatrix(object.modelViewMatrix);
    (source.onBeforeRender as unknown as MaterialCallback)(webgl, scene, camera, geometry, object, group);
    // three's own shaders of lit materials write the first texture alone
    const first = item.lit && this.drawsToSeveral && !hasOwnShader(source);
    if (first) this.setDrawBuffers(1);
    try {
      this.draw(camera, scene, geometry, material, object, group);
    } finally {
      if (first) this.setDrawBuffers(this.target!.textures.length);
    }
    if (source.uniformsNeedUpdate === true) source.uniformsNeedUpdate = false;
    (object.onAfterRender as unknown as MaterialCallback)(webgl, scene, camera, geometry, source as never, group);
  }
}

const isLeft = (item: RenderItem): boolean => !item.drawn;
/** Arguments of `drawBuffers`, by the number of textures. */
const drawBuffers: number[][] = [];
/** Argument of `clearBufferfv`. */
const clearColor = new Float32Array(4);
const farDepth = new Float32Array([1]);
