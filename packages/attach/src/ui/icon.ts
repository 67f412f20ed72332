import { sharedIcons } from '@farol/editing';

const SVG = 'http://www.w3.org/2000/svg';

export type IconName = keyof typeof sharedIcons;

/**
 * An SVG icon of Farol's own editor.
 * @param size - width and height (CSS pixels)
 */
export function icon(name: IconName, size = 16): SVGSVGElement {
  const made = document.createElementNS(SVG, 'svg');
  made.setAttribute('class', 'icon');
  made.setAttribute('viewBox', '0 0 16 16');
  made.setAttribute('width', String(size));
  made.setAttribute('height', String(size));
  made.setAttribute('aria-hidden', 'true');
  const path = document.createElementNS(SVG, 'path');
  path.setAttribute('d', sharedIcons[name]);
  made.append(path);
  return made;
}
