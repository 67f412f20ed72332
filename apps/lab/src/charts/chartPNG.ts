/**
 * A PNG of an SVG file.
 *
 * @param svg - text of the file, with width and height in pixels
 * @param scale - pixels of the PNG per pixel of the file; 2 by default
 * @throws Error when the browser cannot draw or encode the file
 */
export async function chartPNG(svg: string, scale = 2): Promise<Blob> {
  const url = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
  try {
    const image = new Image();
    image.src = url;
    await image.decode().catch((error: unknown) => {
      throw new Error('The browser cannot draw the chart: save it as SVG.', { cause: error });
    });
    const canvas = document.createElement('canvas');
    canvas.width = Math.round(image.naturalWidth * scale);
    canvas.height = Math.round(image.naturalHeight * scale);
    canvas.getContext('2d')!.drawImage(image, 0, 0, canvas.width, canvas.height);
    const blob = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, 'image/png'));
    if (!blob) throw new Error('The browser cannot make a picture of the chart: save it as SVG.');
    return blob;
  } finally {
    URL.revokeObjectURL(url);
  }
}
