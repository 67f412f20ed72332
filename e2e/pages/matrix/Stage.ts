import type { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import type { Bench } from '../Bench';
import { addSheetLights } from './Sheet';
import { colourMap, normalMap } from './textures';

const { MeshStandardMaterial: Standard } = THREE;

/** A small scene and what draws it, for settings of the renderer, the scene and the camera. */
export class Stage {
  readonly scene = new THREE.Scene();
  readonly camera: THREE.PerspectiveCamera;
  readonly things: THREE.Mesh[];

  constructor(
    private readonly bench: Bench,
    readonly width: number,
    readonly height: number,
  ) {
    const { scene } = this;
    scene.background = new THREE.Color(0x203040);
    const ball = new THREE.SphereGeometry(0.8, 24, 16);
    this.things = [
      new THREE.Mesh(new THREE.PlaneGeometry(12, 8), new Standard({ color: 0x888888, roughness: 0.8 })),
      new THREE.Mesh(ball, new Standard({ color: 0xffcc99, map: colourMap(), normalMap: normalMap(), roughness: 0.4 })),
      new THREE.Mesh(ball, new THREE.MeshPhongMaterial({ color: 0x88aaff, shininess: 40 })),
      new THREE.Mesh(ball, new Standard({ color: 0x88ffcc, transparent: true, opacity: 0.5, roughness: 0.5 })),
      new THREE.Mesh(ball, new THREE.MeshBasicMaterial({ color: 0xcc8844 })),
    ];
    this.things.forEach((thing, i) => {
      if (i === 0) thing.position.z = -1;
      else thing.position.set(((i - 1) % 2) * 2.4 - 1.2 + i * 0.1, i < 3 ? 0.7 : -0.8, i === 3 ? 0.8 : 0);
      scene.add(thing);
    });
    addSheetLights(scene, 5, 4);
    this.camera = new THREE.PerspectiveCamera(40, width / height, 0.5, 40);
    this.camera.position.set(0.5, 0.3, 7);
    this.camera.lookAt(0, 0, 0);
  }

  get webgl(): THREE.WebGLRenderer {
    return this.bench.webgl;
  }

  /** A filtered room, which takes seconds to make. */
  get environment(): THREE.Texture {
    return this.bench.environment();
  }
}

export type Render = (scene: THREE.Object3D, camera: THREE.Camera) => void;

/** How a scene is drawn otherwise than by default. */
export interface Setting {
  /** Parameters of the WebGLRenderer; settings that have the same share one. */
  readonly renderer?: THREE.WebGLRendererParameters;
  /** Left out of the slice, since another setting or test has its shaders. */
  readonly inVerify?: boolean;
  /** Draws to the canvas, of 8 bits. */
  readonly canvas?: boolean;
  readonly target?: THREE.RenderTargetOptions;
  /** Techniques that are not asked, since the README says so. */
  readonly except?: (technique: string) => boolean;
  /** Changes the stage once; nothing else is drawn with it. */
  prepare?(stage: Stage): void;
  /** Draws, default once; leaves the renderer as it was. */
  draw?(stage: Stage, render: Render, farol: FarolRenderer | null): void;
}
