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
