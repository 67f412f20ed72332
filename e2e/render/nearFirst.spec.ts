import type { TechniqueName } from '@farol/renderer';
import type * as Three from 'three';
import { checkAgreement } from '../support/agreement';
import { compareImages, isFlat } from '../support/images';
import { expect, test } from '../support/benchTest';

test('surfaces that hide others are drawn first where it spares shading, and the picture stays that of stock three', async ({
  benchPage: page,
}) => {
  const seen = await page.evaluate(async () => {
    const { Bench, three } = window.testPage;
    const bench = new Bench(240, 160);
    const scene = new three.Scene();
    const camera = new three.PerspectiveCamera(60, 1.5, 0.1, 100);
    const order: number[] = [];
    // three draws by material: the farther, the earlier
    for (const depth of [32, 16, 8, 4, 2]) {
      const material = new three.MeshStandardMaterial({ color: 0x112233 * (depth % 7), roughness: 0.4 });
      const sheet = new three.Mesh(new three.PlaneGeometry(depth * 2, depth), material);
      sheet.position.set(depth / 8, depth / 16, -depth);
      sheet.rotation.z = depth;
      sheet.onBeforeRender = () => void order.push(depth);
      scene.add(sheet);
    }
    const light = new three.PointLight(0xffeedd, 60, 40);
    scene.add(light, new three.AmbientLight(0xffffff, 0.3));
    const drawn = () => {
      order.length = 0;
      const image = bench.byTechnique('auto', scene, camera);
      return { order: [...order], image };
    };
    const first = drawn();
    await bench.farol.ready;
    let last = first;
    for (let frame = 0; frame < 64 && last.order[0] === 32; frame++) last = drawn();
    return { stock: bench.stock(scene, camera), first, last };
  });
  expect(seen.first.order).toEqual([32, 16, 8, 4, 2]);
  expect(seen.last.order).toEqual([2, 4, 8, 16, 32]);
  expect(isFlat(seen.stock)).toBe(false);
  expect(compareImages(seen.stock, seen.last.image).psnr).toBeGreaterThan(90);
});

test('of coplanar surfaces, in any order of materials, every technique shows the one that stock three shows @verify', async ({
  benchPage: page,
}) => {
  const seen = await page.evaluate(async () => {
    const { Bench, randomIn, three, techniquesInTurn } = window.testPage;
    const bench = new Bench(240, 160);
    const scene = new three.Scene();
    const camera = new three.PerspectiveCamera(60, 1.5, 0.1, 100);
    const random = randomIn(3);
    const order: number[] = [];
    // the one at 3 m hides half of the picture, and three draws most others before it
    const depths = [6, 9, 12, 6, 9, 12, 9, 6, 12, 9, 6, 3, 12, 9, 6];
    const materials = depths.map((_, i) => {
      const color = new three.Color().setHSL(i / depths.length, 0.7, 0.5);
      return i === 6
        ? new three.MeshBasicMaterial({ color })
        : new three.MeshStandardMaterial({ color, roughness: 0.6 });
    });
    materials.forEach((material, i) => {
      const depth = depths[i];
      for (let k = 0; k < (i % 4 === 0 ? 2 : 1); k++) {
        const geometry = new three.PlaneGeometry(depth * random(0.4, 0.9), depth * random(0.3, 0.7));
        const mesh = new three.Mesh(geometry, material);
        mesh.position.set(depth * random(-0.5, 0.5), depth * random(-0.35, 0.35), -depth);
        if (depth === 3) mesh.position.set(-1.2, 0, -depth);
        if (depth === 3) mesh.scale.set(3 / geometry.parameters.width, 4 / geometry.parameters.height, 1);
        mesh.onBeforeRender = () => void order.push(material.id);
        scene.add(mesh);
      }
    });
    // the order of materials is found without these
    const late = [2, 6, 12].map((i) =>
      scene.children.filter((child) => (child as Three.Mesh).material === materials[i]),
    );
    const show = (isLit: boolean, isShown: boolean) =>
      late.forEach((meshes, i) => meshes.forEach((mesh) => (mesh.visible = isShown && (i !== 1 || !isLit))));
    show(true, false);
    scene.add(new three.AmbientLight(0xffffff, 1), new three.PointLight(0xffeedd, 60, 40));
    const by = (technique: TechniqueName) => {
      order.length = 0;
      const image = bench.byTechnique(technique, scene, camera);
      return { technique, image, order: [...new Set(order)] };
    };
    by('auto');
    await bench.farol.ready;
    for (let frame = 0; frame < 64; frame++) by('forward-single-pass');
    const pictures = [];
    for (const technique of techniquesInTurn(3)) {
      by(technique);
      await bench.farol.ready;
      show(true, false);
      const [first, stock] = [by(technique), bench.stock(scene, camera)];
      // techniques with a G-buffer draw unlit objects after all lit ones
      show(!/auto|single|tiled-f|clustered-f/.test(technique), true);
      pictures.push({ ...first, stock }, { ...by(technique), stock: bench.stock(scene, camera) });
    }
    // every surface then hides those drawn before it, whatever their depth
    bench.target.depthBuffer = false;
    bench.target.dispose();
    const stock = bench.stock(scene, camera);
    return { pictures, flat: { ...by('forward-single-pass'), stock } };
  });
  expect(compareImages(seen.flat.stock, seen.flat.image).psnr, 'without a depth buffer').toBeGreaterThan(120);
  for (const { technique, image, stock, order } of seen.pictures) {
    expect(isFlat(stock)).toBe(false);
    checkAgreement(technique, compareImages(stock, image), `${technique}, ${order.length} materials`);
    const isById = order.join() === order.toSorted((a, b) => a - b).join();
    expect(isById, `${technique} draws by ids`).toBe(technique === 'forward' || technique === 'forward-plus');
  }
});
