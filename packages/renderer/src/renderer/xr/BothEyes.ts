import {
  AlwaysDepth,
  type ArrayCamera,
  type Color,
  type ColorSpace,
  ExternalTexture,
  Material,
  NoBlending,
  PerspectiveCamera,
  type Object3D,
  type Scene,
  Vector2,
  Vector4,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import type { Frame } from '../../frame/Frame';
import { isEmptyCallback } from '../../frame/hostCallbacks';
import type { RenderItem } from '../../frame/RenderItem';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import { isDrawnAsCanvas, setDrawnAsCanvas } from '../../three/drawnAsCanvas';
import { framebufferHandle } from '../../three/handles';
import { bindFramebuffer, bindTexture, unbindTexture, isDepthReversed } from '../../three/state';
import { type Eye, EyeTwins } from './EyeTwins';
import presentEyes from './presentEyes.glsl?raw';
import { setUnionCamera } from './unionCamera';

interface MultisampledMultiview {
  framebufferTextureMultisampleMultiviewOVR(
    target: number,
    attachment: number,
    texture: WebGLTexture | null,
    level: number,
    samples: number,
    first: number,
    views: number,
  ): void;
}

/** Techniques that have no full-screen passes, only draws of objects. */
const TECHNIQUES = new Set(['clustered-forward', 'forward-single-pass']);
/** Number of samples that three uses with `antialias`. */
const SAMPLES = 4;
/** Bytes of a pixel of an eye: colour, depth. */
const BYTES = 8;

type Attach = (attachment: number, texture: WebGLTexture) => void;

/** Function that attaches both layers of an array to a framebuffer with the session's number of samples. */
function attachmentsOf(gl: WebGL2RenderingContext): Attach | 'none' {
  const multiview = gl.getExtension('OVR_multiview2');
  if (multiview === null) return 'none';
  if (!gl.getContextAttributes()!.antialias)
    return (to, texture) => multiview.framebufferTextureMultiviewOVR(gl.FRAMEBUFFER, to, texture, 0, 0, 2);
  const multisampled = gl.getExtension('OCULUS_multiview') as MultisampledMultiview | null;
  if (multisampled === null) return 'none';
  return (to, texture) =>
    multisampled.framebufferTextureMultisampleMultiviewOVR(gl.FRAMEBUFFER, to, texture, 0, SAMPLES, 0, 2);
}

/** Draws both eyes of an XR session at once, by OVR_multiview2, to a texture array, and writes them to the session's layer. */
export class BothEyes {
  readonly twins = new EyeTwins();
  readonly adapters = [this.twins];
  /** Camera whose frustum contains both eyes'. */
  readonly camera = new PerspectiveCamera();
  /** Function that attaches arrays to the bound framebuffer; null before the device's support is tested. */
  private attach: Attach | 'none' | null = null;
  /** Target of one texel as three sees it; its framebuffer has the arrays attached. */
  private target: WebGLRenderTarget | null = null;
  private readonly size = new Vector2();
  private color: WebGLTexture | null = null;
  private depth: WebGLTexture | null = null;
  private eyes!: ArrayCamera;
  private layer!: WebGLRenderTarget;
  private readonly viewport = new Vector4();
  private readonly colors = new ExternalTexture();
  private readonly depths = new ExternalTexture();
  private readonly pass = new FullscreenPass({
    program: 'both eyes',
    fragment: 'presentEyes',
    microShaders: { presentEyes },
    shared: ['farol_offset'],
    uniforms: {
      farol_eyes: { value: this.colors },
      farol_eyeDepths: { value: this.depths },
      farol_eyeWidth: { value: 0 },
    },
    blending: NoBlending,
    depthTest: true,
    depthWrite: true,
  });

  constructor(private readonly webgl: WebGLRenderer) {
    this.camera.matrixWorldAutoUpdate = false;
  }

  get bytes(): number {
    return this.color === null ? 0 : 2 * BYTES * this.size.x * this.size.y;
  }

  /** Binds the arrays if device, session and scene support it. @returns whether the arrays are bound */
  begin(scene: Object3D, eyes: ArrayCamera): boolean {
    const { webgl, camera } = this;
    const gl = webgl.getContext() as WebGL2RenderingContext;
    const layer = webgl.getRenderTarget() as WebGLRenderTarget | null;
    const { background, backgroundNode } = scene as Scene & { backgroundNode?: unknown };
    this.attach ??= attachmentsOf(gl);
    if (this.attach === 'none') return false;
    if (layer === null || !isDrawnAsCanvas(layer) || layer.scissorTest || layer.textures.length > 1) return false;
    if (isDepthReversed(webgl) || webgl.capabilities.logarithmicDepthBuffer || layer.stencilBuffer) return false;
    if ((background && !(background as Color).isColor) || backgroundNode || !webgl.autoClear) return false;
    const cameras = eyes.cameras as Eye[];
    if (cameras.length !== 2 || !setUnionCamera(camera, cameras)) return false;
    const [first, second] = [cameras[0].viewport, cameras[1].viewport];
    const isBeside = second.x === first.x + first.z && second.y === first.y;
    if (!isBeside || second.z !== first.z || second.w !== first.w) return false;
    camera.layers.mask = cameras[0].layers.mask | cameras[1].layers.mask;
    this.eyes = eyes;
    this.layer = layer;
    this.viewport.set(first.x, first.y, 2 * first.z, first.w);
    this.twins.set(camera, cameras);
    this.bind(gl, first.z, first.w, this.attach);
    this.twins.begin(gl);
    return true;
  }

  /** Whether the frame holds something that cannot be drawn for both eyes at once; the frame is then drawn eye by eye. */
  refuses({ view, fields, queue }: Frame, technique: string): boolean {
    if (view !== 'final' || fields !== null || !TECHNIQUES.has(technique) || queue.transmissive.length > 0) return true;
    return queue.opaque.some(this.refused) || queue.transparent.some(this.refused);
  }

  /** Writes both eyes to the session's layer. Called inside three's `render`. */
  present(frame: Frame): void {
    const { pass, target, viewport } = this;
    pass.uniforms.farol_eyeWidth.value = viewport.z / 2;
    pass.material(frame).depthFunc = AlwaysDepth;
    frame.target = this.layer;
    frame.viewport.copy(viewport);
    frame.uniforms.farol_offset.value.set(viewport.x, viewport.y);
    frame.bindTarget();
    pass.draw(frame);
    frame.target = target;
    frame.viewport.copy(target!.viewport);
    frame.bindTarget();
  }

  end(): void {
    this.twins.end();
    this.webgl.setRenderTarget(this.layer);
  }

  /** Frees the arrays; also called when a session ends. */
  readonly dispose = (): void => {
    this.webgl.xr.removeEventListener('sessionend', this.dispose);
    const gl = this.webgl.getContext();
    this.target?.dispose();
    gl.deleteTexture(this.color);
    gl.deleteTexture(this.depth);
    this.target = this.color = this.depth = null;
    this.size.set(0, 0);
    this.pass.dispose();
    this.attach = null;
  };

  private readonly refused = ({ object, material, shading, ownShader }: RenderItem): boolean => {
    const [first, second] = this.eyes.cameras;
    const { isMesh, isLine } = object as Object3D & { isMesh?: boolean; isLine?: boolean };
    return (
      shading === 'nodes' ||
      ownShader ||
      !(isMesh || isLine) ||
      object.layers.test(first.layers) !== object.layers.test(second.layers) ||
      !isEmptyCallback(object.onBeforeRender) ||
      !isEmptyCallback(object.onAfterRender) ||
      material.dithering ||
      material.onBeforeRender !== Material.prototype.onBeforeRender
    );
  };

  private bind(gl: WebGL2RenderingContext, width: number, height: number, attach: Attach): void {
    const { webgl, size } = this;
    if (size.x !== width || size.y !== height) {
      this.dispose();
      webgl.xr.addEventListener('sessionend', this.dispose);
      size.set(width, height);
      this.color = this.makeArray(gl, gl.RGBA8);
      this.depth = this.makeArray(gl, gl.DEPTH_COMPONENT24);
      this.colors.sourceTexture = this.color;
      this.depths.sourceTexture = this.depth;
      const target = (this.target = new WebGLRenderTarget(1, 1, {
        colorSpace: this.layer.texture.colorSpace as ColorSpace,
        depthBuffer: false,
      }));
      setDrawnAsCanvas(target, true);
      target.viewport.set(0, 0, width, height);
      target.scissor.set(0, 0, width, height);
      webgl.initRenderTarget(target);
      bindFramebuffer(webgl, gl.FRAMEBUFFER, framebufferHandle(webgl, target)!);
      attach(gl.COLOR_ATTACHMENT0, this.color);
      attach(gl.DEPTH_ATTACHMENT, this.depth);
    }
    webgl.setRenderTarget(this.target);
  }

  private makeArray(gl: WebGL2RenderingContext, format: number): WebGLTexture {
    const { webgl, size } = this;
    const texture = gl.createTexture();
    bindTexture(webgl, gl.TEXTURE_2D_ARRAY, texture);
    gl.texStorage3D(gl.TEXTURE_2D_ARRAY, 1, format, size.x, size.y, 2);
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
      gl.texParameteri(gl.TEXTURE_2D_ARRAY, filter, gl.NEAREST);
    unbindTexture(webgl);
    return texture;
  }
}
