import type { Scene } from '@farol/engine';
import { splitName } from './assetNames';

/** A class of a name: 'Script 2' gives 'Script2', 'door opener' 'DoorOpener'. */
export function classNameOf(script: string): string {
  const words = splitName(script)
    .leaf.replace(/\.[jt]s$/i, '')
    .normalize('NFD')
    .replaceAll(/\p{M}/gu, '')
    .split(/[^A-Za-z0-9_$]+/)
    .filter((word) => word !== '');
  const name = words.map((word) => word[0].toUpperCase() + word.slice(1)).join('');
  return /^[A-Za-z_$]/.test(name) ? name : `Script${name}`;
}

/** Whether the text of a script is JavaScript, by its name; else it is TypeScript. */
export const isJavaScript = (script: string): boolean => /\.js$/i.test(script);

/** The type of components that a script's text declares: its `typeName`, else the name of the class; null where it has none. */
export function typeNameOf(source: string): string | null {
  const [, declared] = /\bstatic\b[^;=]*\btypeName\b[^;=]*=\s*['"`]([\w$]+)['"`]/.exec(source) ?? [];
  if (declared) return declared;
  const [, named] = /\bexport\s+default\s+class\s+(?!extends\b)([\w$]+)/.exec(source) ?? [];
  return named ?? null;
}

/** The script whose class a type of components is; null for types that come from elsewhere. */
export function scriptOfType(scene: Scene, typeName: string): string | null {
  const found = scene.assets
    .fieldAssets('script')
    .find((asset) => typeNameOf(asset.get('source') as string) === typeName);
  return found?.name ?? null;
}
