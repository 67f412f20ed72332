import { useEffect, useRef } from 'preact/hooks';

interface PixelCanvasProps {
  /** Null without a picture: the canvas then has the size `width` × `height`, or the browser's default. */
  pixels: ImageData | null;
  label: string;
  class?: string;
  width?: number;
  height?: number;
}

/** A canvas of a picture's size that shows the picture. */
export function PixelCanvas({ pixels, label, ...attributes }: PixelCanvasProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    if (!pixels || !canvas.current) return;
    canvas.current.width = pixels.width;
    canvas.current.height = pixels.height;
    canvas.current.getContext('2d')?.putImageData(pixels, 0, 0);
  }, [pixels]);
  return <canvas ref={canvas} {...attributes} role="img" aria-label={label} />;
}
