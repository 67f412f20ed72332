import { CanvasTexture, LinearFilter } from 'three';
import { iconPaths } from '../style/iconPaths';

/** Icons of the viewport, in the order of the atlas. */
export const iconKinds = [
  'point',
  'spot',
  'directional',
  'ambient',
  'hemisphere',
  'rectangle',
  'disc',
  'tube',
  'camera',
  'decal',
  'sound',
  'particles',
  'fog',
] as const;

const CELL = 64;

/** Texture with one row of icons: red is the stroke, green the disc behind it. */
export function makeIconAtlas(): CanvasTexture {
  const canvas = document.createElement('canvas');
  canvas.width = CELL * iconKinds.length;
  canvas.height = CELL;
  const context = canvas.getContext('2d')!;
  context.fillStyle = '#000';
  context.fillRect(0, 0, canvas.width, canvas.height);
  iconKinds.forEach((kind, i) => {
    context.setTransform(1, 0, 0, 1, CELL * (i + 0.5), CELL / 2);
    context.fillStyle = '#0f0';
    context.beginPath();
    context.arc(0, 0, CELL * 0.47, 0, 2 * Math.PI);
    context.fill();
    const scale = (CELL / 16) * 0.64;
    context.scale(scale, scale);
    context.translate(-8, -8);
    context.strokeStyle = '#ff0';
    context.lineWidth = 1.5;
    context.lineCap = context.lineJoin = 'round';
    context.stroke(new Path2D(iconPaths[kind]));
  });
  const texture = new CanvasTexture(canvas);
  texture.minFilter = LinearFilter;
  texture.generateMipmaps = false;
  return texture;
}
