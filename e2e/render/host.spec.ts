import { expect, test } from '../support/test';

test.beforeEach(async ({ page, pagesURL }) => {
  await page.goto(pagesURL);
  await page.waitForFunction(() => 'testPage' in window);
});

test('the host finds its scene, renderer and three as they were, and stock three draws the same after Farol', async ({
  page,
}) => {
  const results = await page.evaluate(() => {
    const { Bench, compareImages, farol, materialScene, three } = window.testPage;
    const bench = new Bench(80, 60);
    const { scene, camera } = materialScene(80, 60, { count: 8 });
    const { webgl } = bench;
    webgl.setClearColor(0x123456, 0.5);
    const first = bench.stock(scene, camera);
    const gl = webgl.getContext() as WebGL2RenderingContext;
    const snapshot = () => {
      const objects: unknown[] = [];
      scene.traverse((object) => {
        const mesh = object as InstanceType<typeof three.Mesh>;
        const material = mesh.material as InstanceType<typeof three.Material> | undefined;
        objects.push([
          object.uuid,
          object.parent?.uuid,
          object.children.map((child) => child.uuid),
          object.visible,
          object.layers.mask,
          object.matrixWorld.elements.join(),
          Object.keys(object).sort().join(),
          material && [
            material.uuid,
            material.version,
            material.side,
            material.transparent,
            Object.keys(material).sort().join(),
          ],
        ]);
      });
      return JSON.stringify([
        objects,
        Object.keys(scene).sort(),
        JSON.stringify(three.ShaderChunk),
        Object.keys(three.ShaderLib).length,
        webgl.getClearColor(new three.Color()).getHex(),
        webgl.getClearAlpha(),
        webgl.autoClear,
        webgl.toneMapping,
        webgl.getRenderTarget() === null,
        Array.from(gl.getParameter(gl.COLOR_CLEAR_VALUE) as Float32Array),
        gl.getParameter(gl.SCISSOR_TEST),
        gl.getParameter(gl.FRAMEBUFFER_BINDING) === null,
      ]);
    };
    return (Object.keys(farol.techniques) as (keyof typeof farol.techniques)[]).map((technique) => {
      bench.stock(scene, camera);
      const before = snapshot();
      bench.byTechnique(technique, scene, camera);
      const after = snapshot();
      return { technique, same: before === after, again: compareImages(first, bench.stock(scene, camera)).largest };
    });
  });
  for (const { technique, same, again } of results) {
    expect(same, `${technique}: the host is as it was`).toBe(true);
    expect(again, `${technique}: stock three afterwards`).toBe(0);
  }
});
