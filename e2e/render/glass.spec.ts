import type * as Three from 'three';
import type { TechniqueName } from '@farol/renderer';
import { checkAgreement } from '../support/agreement';
import { expect, test } from '../support/benchTest';

test('double-sided glass is seen through its own back faces, as in stock three', async ({ benchPage: page }) => {
  const results = await page.evaluate(() => {
    const { Bench, compareImages, techniquesInTurn, three } = window.testPage;
    const width = 160;
    const height = 96;
    const bench = new Bench(width, height);
    bench.farol.inferredScale = 1;
    const scene = new three.Scene();
    scene.background = new three.Color(0x203040);
    const wall = new three.Mesh(new three.PlaneGeometry(14, 9), new three.MeshStandardMaterial({ color: 0xaa7755 }));
    wall.position.z = -2;
    scene.add(wall);
    const side = three.DoubleSide;
    const kinds: ConstructorParameters<typeof three.MeshPhysicalMaterial>[0][] = [
      { roughness: 0.1 },
      { roughness: 0.5, thickness: 0.6, attenuationColor: 0x88ffaa, attenuationDistance: 1 },
      { roughness: 0, thickness: 0.8, dispersion: 4, ior: 1.6 },
      { roughness: 0.2, iridescence: 1, thickness: 0.2 },
      { roughness: 0.2, transparent: true, opacity: 0.6 },
      { roughness: 0.2, side: three.FrontSide },
    ];
    const shape = new three.TorusKnotGeometry(0.55, 0.22, 48, 8);
    kinds.forEach((kind, i) => {
      const material = new three.MeshPhysicalMaterial({ transmission: 0.9, side, ...kind });
      const thing = new three.Mesh(shape, material);
      thing.position.set((i % 3) * 2.2 - 2.2, i < 3 ? 1.1 : -1.1, 0);
      thing.rotation.set(i, 0.5, 0);
      scene.add(thing);
    });
    scene.add(new three.AmbientLight(0x404050, 1));
    for (let i = 0; i < 6; i++) {
      const light = i % 2 ? new three.PointLight(0xffffff, 20, 9) : new three.SpotLight(0xffffff, 40, 12, 0.9, 0.5);
      light.color.setHSL(i / 6, 0.6, 0.6);
      light.position.set((i % 3) * 3 - 3, i < 3 ? 2 : -2, i < 4 ? 3 : -1);
      scene.add(light);
    }
    const camera = new three.PerspectiveCamera(45, width / height, 0.5, 40);
    camera.position.z = 6;
    const cameras = [0, 1].map((i) => {
      const one = camera.clone() as Three.PerspectiveCamera & { viewport: Three.Vector4 };
      one.position.x = i - 0.5;
      one.viewport = new three.Vector4((i * width) / 2, 0, width / 2, height);
      one.aspect = width / 2 / height;
      one.updateProjectionMatrix();
      one.updateMatrixWorld();
      return one;
    });
    const array = new three.ArrayCamera(cameras);
    array.copy(camera, false);
    array.cameras = cameras;
    const compare = (setting: string, view: Three.Camera, names: readonly TechniqueName[]) => {
      const stock = bench.stock(scene, view);
      return names.map((technique) => ({
        setting,
        technique,
        ...compareImages(stock, bench.byTechnique(technique, scene, view)),
      }));
    };
    const whole = compare('one camera', camera, techniquesInTurn(4));
    bench.webgl.transmissionResolutionScale = 0.5;
    const half = compare('half the resolution', camera, techniquesInTurn(4));
    bench.webgl.transmissionResolutionScale = 1;
    const several = compare('two cameras', array, techniquesInTurn(4));
    const sides = scene.children.map((child) => ((child as Three.Mesh).material as Three.Material | undefined)?.side);
    return { differences: [...whole, ...half, ...several], kept: sides.filter((one) => one === side).length };
  });
  expect(results.kept, 'materials that are double-sided still').toBe(5);
  for (const { setting, technique, ...difference } of results.differences)
    checkAgreement(technique, difference, setting);
});
