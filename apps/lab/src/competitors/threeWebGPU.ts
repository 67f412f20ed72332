import { ClusteredLighting } from 'three/addons/lighting/ClusteredLighting.js';
import { type PerspectiveCamera, PointLight, SpotLight } from 'three';
import { WebGPURenderer } from 'three/webgpu';
import type { StageScene } from '../stage/StageScene';
import { webgpuName } from '../stage/webgpuName';
import { clusterFill, type Reach } from './clusterFill';
import type { Competitor, Drawing } from './Competitor';
import { competitorNames } from './competitorNames';
import { lackingInThree, refuseMatter } from './refuseMatter';
import { refuseTextures } from './refuseTextures';
import { type CopyingDevice, readWebGPU } from './readWebGPU';

/** Default sizes of the ClusteredLighting addon: side of a tile (pixels), slices along the depth. */
const TILE = 32;
const SLICES = 24;
/** Number of lights that can be added while the scene is measured. */
const SPARE = 10;
/** Factor by which a cluster may become fuller while lights move. */
const ROOM = 1.15;
/** Number of textures that the addon adds to each material. */
const LIGHT_TEXTURES = 2;
/** Factor by which the addon enlarges its storage. */
const HEADROOM = 1.5;

/** The part of WebGPU used here; TypeScript's library lacks it. */
interface Device extends CopyingDevice {
  readonly queue: CopyingDevice['queue'] & { onSubmittedWorkDone(): Promise<void> };
  readonly limits: { readonly maxStorageBufferBindingSize: number; readonly maxSampledTexturesPerShaderStage: number };
  createShaderModule(descriptor: { code: string }): unknown;
  addEventListener(type: 'uncapturederror', listener: (event: Event) => void): void;
}

/**
 * three's WebGPURenderer with the ClusteredLighting addon, whose clusters hold as many lights as the scene needs. Lights
 * that cast shadows are not clustered: each material loops over them, as in the stock renderer.
 */
export const threeWebGPU: Competitor = {
  name: 'three-webgpu',
  ...competitorNames['three-webgpu'],
  async unavailable() {
    if (!('gpu' in navigator)) return 'This browser has no WebGPU: use a newer one, over https or on this machine.';
    return (await webgpuName()) === null ? 'This browser has WebGPU, but no device for it here.' : null;
  },
  refuses: (scene) => refuseMatter(scene, lackingInThree),
  async open(canvas, scene, signal): Promise<Drawing> {
    const { three, camera, width, height } = scene;
    const renderer = new WebGPURenderer({
      canvas,
      antialias: false,
      alpha: false,
      powerPreference: 'high-performance',
    });
    await renderer.init();
    signal.throwIfAborted();
    const { backend } = renderer as unknown as { backend: { isWebGPUBackend?: boolean; device: Device } };
    if (!backend.isWebGPUBackend) throw new Error('WebGPURenderer found no WebGPU device: restart the browser.');
    const { device } = backend;
    refuseTextures(scene, device.limits.maxSampledTexturesPerShaderStage, LIGHT_TEXTURES);
    let problem = '';
    const tell = ({ message }: { message: string }): void => void (problem ||= message.split('\n')[0].slice(0, 200));
    Object.assign(renderer, { onError: tell, onDeviceLost: tell });
    // errors are reported by `check`, not on the console
    device.addEventListener('uncapturederror', (event) => event.preventDefault());
    saltShaderModules(device);
    const { limit, dropped } = clustersOf(scene, device.limits.maxStorageBufferBindingSize);
    const lights = scene.lights.length + scene.still.length + SPARE;
    renderer.lighting = new ClusteredLighting(Math.max(16, lights), TILE, SLICES, limit);
    renderer.shadowMap.enabled = [...scene.lights, ...scene.still].some(({ castShadow }) => castShadow);
    renderer.setPixelRatio(1);
    renderer.setSize(width, height, false);
    return {
      gl: null,
      render: () => void renderer.render(three, camera),
      finish: () => device.queue.onSubmittedWorkDone(),
      check() {
        if (problem) throw new Error(`WebGPU: ${problem}`);
      },
      readPicture: () => readWebGPU(device, canvas),
      dropped: () => dropped,
      dispose: () => void renderer.dispose(),
    };
  },
};

/** Maximum number of lights per cluster, and the number of lights left out when memory limits it. */
function clustersOf(scene: StageScene, memory: number): { limit: number; dropped: number } {
  const { width, height } = scene;
  const camera = scene.camera as PerspectiveCamera;
  const grid = { width, height, tile: TILE, slices: SLICES };
  const reaches: Reach[] = [];
  scene.three.updateMatrixWorld();
  camera.updateMatrixWorld();
  for (const light of [...scene.lights, ...scene.still]) {
    if (!(light instanceof PointLight || light instanceof SpotLight)) continue;
    // the sphere around a spot light's cone is an upper bound
    reaches.push({ centre: light.position, radius: light.distance || Infinity });
  }
  const clusters = Math.ceil(width / TILE) * Math.ceil(height / TILE) * SLICES;
  const most = Math.max(16, 16 * Math.floor(memory / (clusters * HEADROOM * 4) / 16));
  const { fullest } = clusterFill(reaches, camera, grid);
  const needed = Math.min(fullest * ROOM + SPARE, reaches.length + SPARE);
  const limit = Math.min(most, Math.max(16, 16 * Math.ceil(needed / 16)));
  return { limit, dropped: fullest > limit ? clusterFill(reaches, camera, grid, limit).dropped : 0 };
}

/** Prevents that pipelines come from the browser's cache, like `saltShaders` for WebGL. */
function saltShaderModules(device: Device): void {
  const salt = `\n// ${Math.random().toString(36).slice(2)}\n`;
  const create = device.createShaderModule;
  device.createShaderModule = (descriptor) => create.call(device, { ...descriptor, code: descriptor.code + salt });
}
