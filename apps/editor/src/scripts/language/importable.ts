import type ts from 'typescript-in-browser';

/** Modules whose exports are suggested before they are imported. */
const MODULES = ['@farol/engine/fields', '@farol/engine', 'three'];

/** A name that can be imported. */
export interface ImportableName {
  readonly name: string;
  readonly module: string;
  readonly symbol: ts.Symbol;
}

/** Exports of `MODULES`, cached for each program. */
export function importableNames(
  program: ts.Program,
  files: Readonly<Record<string, string>>,
): readonly ImportableName[] {
  const checker = program.getTypeChecker();
  const seen = new Set<string>();
  return MODULES.flatMap((module) => {
    const source = program.getSourceFile(files[module]);
    const symbol = source && checker.getSymbolAtLocation(source);
    if (!symbol) return [];
    return checker.getExportsOfModule(symbol).flatMap((each): ImportableName[] => {
      const { name } = each;
      if (name === 'default' || seen.has(name)) return [];
      seen.add(name);
      return [{ name, module, symbol: each }];
    });
  });
}

/** The edit that imports a name: position and text to insert. */
export function importEdit(text: string, name: string, module: string): { at: number; insert: string } {
  const word = module.replaceAll(/[.*+?^${}()|[\]\\/]/g, String.raw`\$&`);
  const existingImport = new RegExp(String.raw`^import\s*\{([^}]*)\}\s*from\s*(['"])${word}\2`, 'm').exec(text);
  if (existingImport) {
    const names = existingImport[1];
    const end = existingImport.index + existingImport[0].indexOf('{') + 1 + names.trimEnd().length;
    const separator = names.trim() === '' ? ' ' : names.trimEnd().endsWith(',') ? ' ' : ', ';
    return { at: end, insert: separator + name + (names.trim() === '' && names === '' ? ' ' : '') };
  }
  const imports = [...text.matchAll(/^import\s[^;'"]*['"][^'"]*['"];?[^\S\n]*\n/gm)];
  const last = imports.at(-1);
  const at = last ? last.index + last[0].length : 0;
  return { at, insert: `import { ${name} } from '${module}';\n` };
}
