import { expectAsMeasured } from '../support/agreement';
import { expect, test } from '../support/benchTest';

test('maps of a device without multiple draws in a call, and after a lost context: the same', async ({
  benchPage: page,
  watch,
}) => {
  const results = await page.evaluate(async () => {
    const { Bench, compareImages, three } = window.testPage;
    const begin = () => {
      const bench = new Bench(96, 64, { losesContext: true });
      bench.webgl.shadowMap.enabled = true;
      const scene = new three.Scene();
      const camera = new three.PerspectiveCamera(60, 1.5, 0.1, 50);
      camera.position.set(0, 3, 9);
      camera.lookAt(0, 0, 0);
      const material = new three.MeshStandardMaterial();
      const floor = new three.Mesh(new three.PlaneGeometry(24, 24), material);
      floor.rotation.x = -Math.PI / 2;
      const knot = new three.Mesh(new three.TorusKnotGeometry(0.8, 0.25, 96, 12), material);
      knot.position.set(1, 1.5, 0);
      for (const mesh of [floor, knot]) mesh.castShadow = mesh.receiveShadow = true;
      const point = new three.PointLight(0xffffff, 60, 14);
      point.position.set(-1, 4, 1);
      point.castShadow = true;
      point.shadow.bias = -0.005;
      scene.add(floor, knot, point);
      const turned = (angle: number) => {
        knot.rotation.y = angle;
        const image = bench.byTechnique('deferred', scene, camera);
        return compareImages(bench.stock(scene, camera), image).psnr;
      };
      return { bench, turned };
    };
    const { getExtension } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.getExtension = function (this: WebGL2RenderingContext, name: string) {
      return name === 'WEBGL_multi_draw' ? null : (getExtension.call(this, name as never) as unknown);
    } as typeof getExtension;
    const without = begin();
    const one = [0, 1, 2].map(without.turned);
    WebGL2RenderingContext.prototype.getExtension = getExtension;
    const { bench, turned } = begin();
    const before = [0, 1, 2].map(turned);
    await bench.loseContext();
    return { one, before, after: [2, 3, 4].map(turned) };
  });
  expect(results.one).toEqual(results.before);
  const measured = [65, 61.9, 46.4, 46.4, 56.7, 55.4];
  for (const [i, psnr] of [...results.before, ...results.after].entries())
    expectAsMeasured(psnr, measured[i], `turn ${i}`);
  expect(watch.forgive(/a WebGL context was lost|Context Lost|Context Restored/i)).toBeGreaterThan(0);
});
