/** Width of a thumbnail (pixels). */
const WIDTH = 160;

/** A picture as a data URL, made small (WebP, or PNG where the browser has no WebP). */
export function thumbnailOf(picture: ImageData): string {
  const whole = document.createElement('canvas');
  whole.width = picture.width;
  whole.height = picture.height;
  whole.getContext('2d')!.putImageData(picture, 0, 0);
  const small = document.createElement('canvas');
  small.width = Math.min(WIDTH, picture.width);
  small.height = Math.max(1, Math.round((picture.height * small.width) / picture.width));
  small.getContext('2d')!.drawImage(whole, 0, 0, small.width, small.height);
  return small.toDataURL('image/webp', 0.8);
}
