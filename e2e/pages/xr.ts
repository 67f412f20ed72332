import { FarolRenderer, type TechniqueName } from '@farol/renderer';
import { AmbientOcclusion } from '@farol/renderer/ambient-occlusion';
import { SMAA, TAA } from '@farol/renderer/antialiasing';
import { VolumetricFog } from '@farol/renderer/volumetric-fog';
import { metaQuest3, XRDevice } from 'iwer';
import * as three from 'three';
import { compareImages, isFlat } from '../support/images';
import { isSlice, techniquesInTurn } from './techniquesInTurn';
import { countGpuObjects } from './gpuObjects';
import { loseContext, type PageImage } from './Bench';
import { shadowScene } from './shadowScene';

/** Emulated headset: the canvas stands for the session layer's framebuffer, half of it for each eye. */
const device = new XRDevice(metaQuest3, { stereoEnabled: true });
device.installRuntime({ forceInstall: true });

/** A WebGLRenderer in a session, Farol on it, and a float target of the layer's size. */
class XRBench {
  readonly webgl: three.WebGLRenderer;
  readonly farol: FarolRenderer;
  private next: (() => void) | null = null;
  private target: three.WebGLRenderTarget | null = null;

  constructor(parameters: three.WebGLRendererParameters = {}) {
    this.webgl = new three.WebGLRenderer({ antialias: false, ...parameters });
    document.body.append(this.webgl.domElement);
    this.webgl.setSize(64, 48, false);
    this.webgl.xr.enabled = true;
    this.farol = new FarolRenderer(this.webgl);
    this.webgl.setAnimationLoop(() => this.webgl.xr.isPresenting && this.next?.());
  }

  async start(mode: 'immersive-vr' | 'immersive-ar'): Promise<void> {
    const session = await navigator.xr!.requestSession(mode, { optionalFeatures: ['local-floor'] });
    await this.webgl.xr.setSession(session);
  }

  async end(): Promise<void> {
    await this.webgl.xr.getSession()?.end();
  }

  /** Calls back in the next frame of the session. @returns its result */
  frame<Result>(draw: () => Result): Promise<Result> {
    return new Promise((resolve, reject) => {
      this.next = () => {
        this.next = null;
        try {
          resolve(draw());
        } catch (error) {
          reject(error as Error);
        }
      };
    });
  }

  /** The eyes as one picture, of linear floats; call it in a frame. */
  floats(render: () => void): PageImage {
    const { webgl } = this;
    const { framebufferWidth: width, framebufferHeight: height } = webgl.xr.getBaseLayer() as XRWebGLLayer;
    this.target ??= new three.WebGLRenderTarget(width, height, { type: three.FloatType });
    const layer = webgl.getRenderTarget();
    webgl.setRenderTarget(this.target);
    render();
    const data = new Float32Array(width * height * 4);
    webgl.readRenderTargetPixels(this.target, 0, 0, width, height, data);
    webgl.setRenderTarget(layer);
    return { width, height, data };
  }

  /** The framebuffer of the session's layer, 0 to 1 as it is encoded; call it in a frame. */
  layer(render: () => void): PageImage {
    const { webgl } = this;
    const gl = webgl.getContext();
    render();
    const { framebufferWidth: width, framebufferHeight: height } = webgl.xr.getBaseLayer() as XRWebGLLayer;
    const bytes = new Uint8Array(width * height * 4);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return { width, height, data: Float32Array.from(bytes, (byte) => byte / 255) };
  }

  loseContext(): Promise<void> {
    return loseContext(this.webgl);
  }

  /** Draws frames by a technique until it lacks nothing. */
  async settle(technique: TechniqueName, scene: three.Scene, camera: three.Camera): Promise<void> {
    const { farol } = this;
    farol.technique = technique;
    const draw = () => this.frame(() => farol.render(scene, camera));
    const state = { isReady: false };
    await draw();
    const ready = farol.ready.then(() => (state.isReady = true));
    while (!state.isReady) await draw();
    await ready;
  }
}

/** One eye of a picture. */
function eyeOf({ width, height, data }: PageImage, eye: 0 | 1): PageImage {
  const half = width / 2;
  const part = new Float32Array(half * height * 4);
  for (let y = 0; y < height; y++) {
    const from = (y * width + eye * half) * 4;
    part.set(data.subarray(from, from + half * 4), y * half * 4);
  }
  return { width: half, height, data: part };
}

const xrPage = {
  three,
  device,
  XRBench,
  eyeOf,
  compareImages,
  isFlat,
  shadowScene,
  techniquesInTurn,
  isSlice,
  countGpuObjects,
  effects: { AmbientOcclusion, SMAA, TAA, VolumetricFog },
  xrStereo: () => import('./xrStereo'),
  engine: () => import('@farol/engine'),
  engineXR: () => import('@farol/engine/xr'),
};

declare global {
  interface Window {
    xrPage: typeof xrPage;
  }
}

window.xrPage = xrPage;
