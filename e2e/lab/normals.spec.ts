import { expect, test } from '../support/test';

interface Stage {
  drawNormals(way: string, size: object): Promise<{ picture: ImageData; leaning: number }>;
}

test('figure 4.3: normals by faces lean at edges, those by crease angle do not, and it can be seen @verify', async ({
  page,
}) => {
  await page.goto('./stage.html');
  await page.waitForFunction(() => (window as unknown as { stage?: Stage }).stage);
  const { faces, crease, differing } = await page.evaluate(async () => {
    const { stage } = window as unknown as { stage: Stage };
    const size = { width: 96, height: 54 };
    const [faces, crease] = [await stage.drawNormals('faces', size), await stage.drawNormals('crease', size)];
    const { data } = crease.picture;
    let differing = 0;
    for (let i = 0; i < data.length; i += 4) if (Math.abs(data[i + 1] - faces.picture.data[i + 1]) > 16) differing++;
    return { faces: faces.leaning, crease: crease.leaning, differing: differing / (size.width * size.height) };
  });
  expect(faces).toBeGreaterThan(0.1);
  expect(crease).toBe(0);
  // edges of blocks and mouldings, not the whole picture
  expect(differing).toBeGreaterThan(0.05);
  expect(differing).toBeLessThan(0.5);
});
