import type { Scene } from '@farol/engine';
import { typeNameOf } from '@farol/engine/scripts';
import { splitName } from './assetNames';

/** A class of a name: 'Script 2' gives 'Script2', 'door opener' 'DoorOpener'. */
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

/** Whether the text of a script is JavaScript, by its name; else it is TypeScript. */
export const isJavaScript = (script: string): boolean => /\.m?js$/.test(script);

const DECLARED = /\bstatic\b[^;={]*\btypeName\b[^;={]*=\s*(['"`])([^'"`\n]+)\1/;

/** The type that the text of a script declares for its components; null where they are called after the script. */
function declaredType(source: string): string | null {
  return DECLARED.exec(source)?.[2] ?? null;
}

/** The type of the components of a script; null where it is no class of components, but something that others import. */
export function componentTypeOf(script: string, source: string): string | null {
  if (!/\bexport\s+(default\b|\{[^}]*\bas\s+default\b)/.test(source)) return null;
  return declaredType(source) ?? typeNameOf(script);
}

/** The text of a script under another name: the class that is called after the script gets that name, too. */
export function sourceForName(source: string, from: string, to: string): string {
  const word = classNameOf(from).replaceAll('$', String.raw`\$`);
  const pattern = new RegExp(String.raw`(\bexport\s+default\s+class\s+)${word}(?![\w$])`);
  return source.replace(pattern, (_all, start: string) => start + classNameOf(to));
}

/** The text of a script whose components get another type where it declares one: 'Spin' becomes 'Spin 2'. */
export const sourceForType = (source: string, number: number): string =>
  source.replace(DECLARED, (all, quote: string, type: string) => {
    const end = all.length - type.length - quote.length;
    return `${all.slice(0, end)}${type} ${number}${quote}`;
  });

/** The script that components of a type are of; null for types that come from elsewhere. */
export function scriptOfType(scene: Scene, typeName: string): string | null {
  const found = scene.assets
    .fieldAssets('script')
    .find((asset) => componentTypeOf(asset.name, asset.get('source') as string) === typeName);
  return found?.name ?? null;
}
