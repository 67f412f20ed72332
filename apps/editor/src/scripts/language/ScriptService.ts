import ts from 'typescript-in-browser';
import { type ImportableName, importableNames } from './importable';
import type {
  LanguageQuestions,
  ScriptChange,
  ScriptCompletion,
  ScriptCompletions,
  ScriptDeclarations,
  ScriptDefinition,
  ScriptDiagnostic,
  ScriptHelp,
  ScriptSignature,
} from './LanguageAnswers';
import { fileOfScript, ScriptHost } from './ScriptHost';

const textOf = (parts: readonly ts.SymbolDisplayPart[] | undefined): string =>
  ts.displayPartsToString([...(parts ?? [])]);

/** Documentation with its tags, such as those of parameters. */
function helpOf(parts: readonly ts.SymbolDisplayPart[] | undefined, tags: readonly ts.JSDocTagInfo[] = []): string {
  const lines = tags.map(({ name, text }) => `@${name} ${textOf(text)}`.trim());
  return [textOf(parts), ...lines].filter((line) => line !== '').join('\n');
}

/** Answers queries about the scripts of a scene with TypeScript's language service. */
export class ScriptService implements LanguageQuestions {
  private readonly host: ScriptHost;
  private readonly service: ts.LanguageService;
  private importable: readonly ImportableName[] | null = null;

  constructor(private readonly declarations: ScriptDeclarations) {
    this.host = new ScriptHost(declarations);
    this.service = ts.createLanguageService(this.host);
  }

  /** Adds, replaces or removes texts of scripts. */
  change(changes: readonly ScriptChange[]): void {
    this.host.change(changes);
  }

  diagnostics(script: string): readonly ScriptDiagnostic[] {
    const file = fileOfScript(script);
    const { service } = this;
    const read = (kind: ScriptDiagnostic['kind'], list: readonly ts.Diagnostic[]): ScriptDiagnostic[] =>
      list.map(({ start = 0, length = 0, messageText, category, file: source }) => ({
        kind,
        message: ts.flattenDiagnosticMessageText(messageText, '\n'),
        severity: category === ts.DiagnosticCategory.Error ? 'error' : 'warning',
        line: 1 + (source?.getLineAndCharacterOfPosition(start).line ?? 0),
        from: start,
        to: start + length,
      }));
    const syntax = read('syntax', service.getSyntacticDiagnostics(file));
    // with syntax errors, type errors are misleading
    return syntax.length > 0 ? syntax : read('types', service.getSemanticDiagnostics(file));
  }

  completions(script: string, at: number, isAsked: boolean): ScriptCompletions | null {
    const file = fileOfScript(script);
    const text = this.host.textOf(file);
    const found = this.service.getCompletionsAtPosition(file, at, {
      includeCompletionsWithInsertText: true,
      includeCompletionsWithClassMemberSnippets: false,
      ...(isAsked ? { triggerKind: ts.CompletionTriggerKind.Invoked } : {}),
    });
    if (!found) return null;
    const word = /[\w$]*$/.exec(text.slice(0, at))![0];
    const from = found.optionalReplacementSpan?.start ?? at - word.length;
    const options = found.entries
      .filter(({ kind }) => kind !== ts.ScriptElementKind.warning)
      .map(({ name, kind, insertText, sortText }): ScriptCompletion => ({
        label: name,
        kind,
        ...(insertText === undefined ? {} : { insert: insertText }),
        // suggestions are ranked in TypeScript's order: local declarations before global ones
        boost: sortText === '11' ? 2 : sortText === '15' ? -2 : 0,
      }));
    if (!found.isMemberCompletion && word.length >= 2) options.push(...this.imports(word, options));
    return { from, options };
  }

  completionHelp(script: string, at: number, { label, module }: ScriptCompletion): ScriptHelp | null {
    const file = fileOfScript(script);
    if (module !== undefined) return this.helpOfImport(label, module, at);
    const found = this.service.getCompletionEntryDetails(file, at, label, {}, undefined, {}, undefined);
    if (!found) return null;
    const { displayParts, documentation, tags } = found;
    return { from: at, to: at, type: textOf(displayParts), help: helpOf(documentation, tags) };
  }

  help(script: string, at: number): ScriptHelp | null {
    const found = this.service.getQuickInfoAtPosition(fileOfScript(script), at);
    if (!found) return null;
    const { textSpan, displayParts, documentation, tags } = found;
    const { start, length } = textSpan;
    return { from: start, to: start + length, type: textOf(displayParts), help: helpOf(documentation, tags) };
  }

  signature(script: string, at: number): ScriptSignature | null {
    const found = this.service.getSignatureHelpItems(fileOfScript(script), at, {});
    const item = found?.items.at(found.selectedItemIndex);
    if (!found || !item) return null;
    const active = Math.min(found.argumentIndex, item.parameters.length - 1);
    return {
      from: found.applicableSpan.start,
      before: textOf(item.prefixDisplayParts),
      parameters: item.parameters.map(({ displayParts }) => textOf(displayParts)),
      after: textOf(item.suffixDisplayParts),
      active,
      help: textOf(item.documentation),
      parameterHelp: textOf(item.parameters.at(active)?.documentation),
    };
  }

  definition(script: string, at: number): ScriptDefinition | null {
    for (const { fileName, textSpan } of this.service.getDefinitionAtPosition(fileOfScript(script), at) ?? []) {
      const name = this.host.scriptOf(fileName);
      const source = this.service.getProgram()?.getSourceFile(fileName);
      if (name === null || !source) continue;
      return { script: name, line: 1 + source.getLineAndCharacterOfPosition(textSpan.start).line };
    }
    return null;
  }

  /** Suggestions for a word from modules that are not imported yet. */
  private imports(word: string, others: readonly ScriptCompletion[]): ScriptCompletion[] {
    const program = this.service.getProgram();
    if (!program) return [];
    this.importable ??= importableNames(program, this.declarations.modules);
    const known = new Set(others.map(({ label }) => label));
    const start = word.slice(0, 2).toLowerCase();
    return this.importable
      .filter(({ name }) => name.toLowerCase().startsWith(start) && !known.has(name))
      .map(({ name, module }) => ({ label: name, kind: 'alias', module, boost: -1 }));
  }

  private helpOfImport(name: string, module: string, at: number): ScriptHelp | null {
    const program = this.service.getProgram();
    const found = this.importable?.find((each) => each.name === name && each.module === module);
    if (!program || !found) return null;
    const checker = program.getTypeChecker();
    const parts = found.symbol.getDocumentationComment(checker);
    return { from: at, to: at, type: `import { ${name} } from '${module}'`, help: textOf(parts) };
  }
}
