import * as THREE from 'three';
import { compareImages, type Difference } from '../../support/images';
import type { PageImage } from '../Bench';
import { isSlice } from '../techniquesInTurn';
import type { Cases, Kit } from './Case';

/** Pixels a side of a case's cell. */
export const CELL = 32;
const COLUMNS = 8;
/** Units a side of a cell. */
const SIDE = 2;
/** Point and spot lights. Stock three has each in the text of its shaders, which take longer to compile by it. */
const LIGHTS = isSlice ? 2 : 10;

/** Pixels of the sheet of so many cases. */
export function sheetSize(cases: Cases): { columns: number; rows: number; width: number; height: number } {
  const count = Object.keys(cases).length;
  const columns = Math.min(COLUMNS, count);
  const rows = Math.ceil(count / columns);
  return { columns, rows, width: columns * CELL, height: rows * CELL };
}

/** Lights of every kind that Farol keeps in its own table, over `width` × `height` units. */
export function addSheetLights(scene: THREE.Scene, width: number, height: number): void {
  scene.add(new THREE.AmbientLight(0x404050, 0.5), new THREE.HemisphereLight(0x8899ff, 0x443322, 0.3));
  const sun = new THREE.DirectionalLight(0xfff0dd, 0.7);
  sun.position.set(1, 2, 3);
  scene.add(sun, new THREE.PointLight(0x66aaff, 2, 0, 2).translateZ(4));
  for (let i = 0; i < LIGHTS; i++) {
    const light = i % 3 ? new THREE.PointLight(0xffffff, 7, 6) : new THREE.SpotLight(0xffffff, 9, 8, 0.7, 0.5);
    light.color.setHSL(i / 10, 0.7, 0.6);
    light.position.set((((i * 3) % 10) / 9 - 0.5) * width, ((i % 4) / 3 - 0.5) * height, 1.8);
    scene.add(light);
    if (light instanceof THREE.SpotLight) {
      light.target.position.set(light.position.x * 0.8, light.position.y * 0.8, -1);
      scene.add(light.target);
    }
  }
}

/** Clear colour of the sheet's target: the upper part of each cell is seen through. */
export const CLEAR = { color: 0x203040, alpha: 0.5 } as const;

/**
 * Many cases in one picture, each in its cell, so that a renderer is asked once for all of them: before a wall in its lower
 * part, before nothing above.
 */
export class Sheet {
  readonly scene = new THREE.Scene();
  readonly camera: THREE.PerspectiveCamera;
  readonly width: number;
  readonly height: number;
  readonly names: string[];

  constructor(cases: Cases, kit: Kit) {
    this.names = Object.keys(cases);
    const { columns, rows, width, height } = sheetSize(cases);
    this.width = width;
    this.height = height;
    const { scene } = this;
    scene.environment = kit.environment;
    scene.environmentIntensity = 0.4;
    scene.environmentRotation.set(0.2, 0.7, 0);
    const geometry = new THREE.PlaneGeometry(columns * SIDE * 1.2, SIDE * 0.65);
    const grey = new THREE.MeshStandardMaterial({ color: 0x777777, roughness: 0.8 });
    for (let row = 0; row < rows; row++) {
      const wall = new THREE.Mesh(geometry, grey);
      wall.position.set(0, rows - (row + 0.65) * SIDE, -1);
      scene.add(wall);
    }
    this.names.forEach((name, i) => {
      const cell = new THREE.Group();
      cell.position.set(((i % columns) + 0.5) * SIDE - columns, rows - (Math.floor(i / columns) + 0.5) * SIDE, 0);
      cell.add(cases[name](kit));
      scene.add(cell);
    });
    addSheetLights(scene, columns * SIDE, rows * SIDE);
    this.camera = new THREE.PerspectiveCamera(24, this.width / this.height, 1, 80);
    this.camera.position.z = rows / Math.tan(THREE.MathUtils.degToRad(12));
  }

  /** The cell of each case cut out of a picture of the sheet. */
  cut(image: PageImage): PageImage[] {
    const columns = this.width / CELL;
    return this.names.map((_, i) => {
      const left = (i % columns) * CELL;
      const bottom = this.height - (Math.floor(i / columns) + 1) * CELL;
      const data = new Float32Array(CELL * CELL * 4);
      for (let y = 0; y < CELL; y++) {
        const start = ((bottom + y) * this.width + left) * 4;
        data.set(image.data.subarray(start, start + CELL * 4), y * CELL * 4);
      }
      return { width: CELL, height: CELL, data };
    });
  }

  /** How far apart two pictures of the sheet are, case by case. */
  compare(a: PageImage, b: PageImage): (Difference & { name: string })[] {
    const [as, bs] = [this.cut(a), this.cut(b)];
    return this.names.map((name, i) => ({ name, ...compareImages(as[i], bs[i]) }));
  }
}
