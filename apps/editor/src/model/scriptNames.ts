import type { Scene } from '@farol/engine';
import { typeNameOf } from '@farol/engine/scripts';
import { splitName } from './assetNames';

/** Class name for a script: 'Script2' for 'Script 2', 'DoorOpener' for 'door opener'. */
export function classNameOf(script: string): string {
  const words = splitName(script)
    .leaf.replace(/\.(m?js|ts)$/, '')
    .normalize('NFD')
    .replaceAll(/\p{M}/gu, '')
    .split(/[^A-Za-z0-9_$]+/)
    .filter((word) => word !== '');
  const name = words.map((word) => word[0].toUpperCase() + word.slice(1)).join('');
  return /^[A-Za-z_$]/.test(name) ? name : `Script${name}`;
}

/** Whether a script is JavaScript, by its name; else it is TypeScript. */
export const isJavaScript = (script: string): boolean => /\.m?js$/.test(script);

const DECLARED = /\bstatic\b[^;={]*\btypeName\b[^;={]*=\s*(['"`])([^'"`\n]+)\1/;

/** `typeName` declared in the text of a script; null when its components are named after the script. */
function declaredType(source: string): string | null {
  return DECLARED.exec(source)?.[2] ?? null;
}

/** Component type that a script defines; null when it exports no component class, only helpers for other scripts. */
export function componentTypeOf(script: string, source: string): string | null {
  if (!/\bexport\s+(default\b|\{[^}]*\bas\s+default\b)/.test(source)) return null;
  return declaredType(source) ?? typeNameOf(script);
}

/** Text of a renamed script: a class named after the script is renamed too. */
export function sourceForName(source: string, from: string, to: string): string {
  const word = classNameOf(from).replaceAll('$', String.raw`\$`);
  const pattern = new RegExp(String.raw`(\bexport\s+default\s+class\s+)${word}(?![\w$])`);
  return source.replace(pattern, (_all, start: string) => start + classNameOf(to));
}

/** Text of a copied script, with a number added to a declared `typeName`: 'Spin' becomes 'Spin 2'. */
export const sourceForType = (source: string, number: number): string =>
  source.replace(DECLARED, (all, quote: string, type: string) => {
    const end = all.length - type.length - quote.length;
    return `${all.slice(0, end)}${type} ${number}${quote}`;
  });

/** Script that defines a component type; null for other types. */
export function scriptOfType(scene: Scene, typeName: string): string | null {
  const found = scene.assets
    .fieldAssets('script')
    .find((asset) => componentTypeOf(asset.name, asset.get('source') as string) === typeName);
  return found?.name ?? null;
}
