import { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js';

type Wired = Readonly<Record<string, (...args: unknown[]) => unknown>>;

/**
 * Replaces `Function` in the transcoder's worker, whose bindings (Emscripten's embind) generate callers as text:
 * returns a closure that does the same as the text. The worker gets the source text of this function.
 */
function withoutEval(): void {
  const original = globalThis.Function;
  type Caller = (...values: unknown[]) => (...args: never[]) => unknown;
  type Any = (...args: unknown[]) => unknown;

  /** Makes a JavaScript function that calls C++, without `new Function`: embind's `craftInvokerFunction`. */
  const intoC = (names: readonly string[], body: string): Caller => {
    const count = names.filter((name) => /^argType\d+$/.test(name)).length;
    const hasStack = body.includes('var destructors = []');
    const isMethod = body.includes('var thisWired');
    const returns = body.includes('var ret = ');
    const endings = names.flatMap((name) => {
      const [whole, argument] = /^(?:this|arg(\d+))Wired_dtor$/.exec(name) ?? [];
      if (whole === undefined) return [];
      return [{ name, at: argument === undefined ? 0 : Number(argument) + Number(isMethod) }];
    });
    return (...values) => {
      const valueOf = (name: string): never => values[names.indexOf(name)] as never;
      const call = (name: string, ...args: unknown[]): unknown => (valueOf(name) as Any)(...args);
      const types: Wired[] = Array.from({ length: count }, (_, i) => valueOf(`argType${i}`));
      return function (this: unknown, ...args: unknown[]): unknown {
        if (args.length !== count) {
          const text = `called with ${args.length} arguments, expected ${count}`;
          call('throwBindingError', `function ${String(valueOf('humanName'))} ${text}`);
        }
        const stack: unknown[] | null = hasStack ? [] : null;
        const wired = types.map((type, i) => type.toWireType(stack, args[i]));
        if (isMethod) wired.unshift((valueOf('classParam') as Wired).toWireType(stack, this));
        const result = call('invoker', valueOf('fn'), ...wired);
        if (hasStack) call('runDestructors', stack);
        else for (const { name, at } of endings) call(name, wired[at]);
        return returns ? (valueOf('retType') as Wired).fromWireType(result) : undefined;
      };
    };
  };

  /** Makes a caller of JavaScript methods for C++, without `new Function`: embind's `__emval_get_method_caller`. */
  const outOfC = (names: readonly string[], body: string): Caller => {
    const reads = [...body.matchAll(/argType(\d+)\.readValueFromPointer\(args(?:\+(\d+))?\)/g)];
    const places = reads.map(([, type, offset]) => ({ name: `argType${type}`, offset: Number(offset ?? 0) }));
    const [isNew, hasObject] = [body.includes('new func('), body.includes('func.call(obj')];
    return (...values) => {
      const valueOf = (name: string): unknown => values[names.indexOf(name)];
      const types = places.map(({ name }) => valueOf(name) as Wired);
      const hand = valueOf('emval_returnValue') as Any | undefined;
      return (object: unknown, func: new (...args: unknown[]) => unknown, destructors: unknown, pointer: number) => {
        const args = types.map((type, i) => type.readValueFromPointer(pointer + places[i].offset));
        const plain = func as unknown as Any;
        const [self, ...rest] = hasObject ? [object, ...args] : args;
        const result = isNew ? new func(...args) : plain.call(self, ...rest);
        return hand?.(valueOf('retType'), destructors, result);
      };
    };
  };

  function replacement(...given: string[]): unknown {
    const [names, body] = [given.slice(0, -1), given[given.length - 1]];
    if (names[0] === 'humanName' && names[2] === 'invoker') return intoC(names, body);
    if (names[0] === 'retType' && body.includes('destructorsRef')) return outOfC(names, body);
    throw new EvalError('Text is not run as a program here.');
  }
  replacement.prototype = original.prototype;
  (globalThis as { Function: unknown }).Function = replacement;
}

/** three's KTX2Loader under a Content-Security-Policy without 'unsafe-eval'. */
export class StrictKTX2Loader extends KTX2Loader {
  override init(): Promise<void> {
    if (!this.transcoderPending) {
      const pending = super.init();
      this.transcoderPending = pending.then(() => this.makeStrict());
    }
    return this.transcoderPending;
  }

  /** Prepends `withoutEval` to the worker's text. */
  private async makeStrict(): Promise<void> {
    const before = this.workerSourceURL;
    const text = await (await fetch(before)).text();
    this.workerSourceURL = URL.createObjectURL(new Blob([`(${withoutEval.toString()})();\n`, text]));
    URL.revokeObjectURL(before);
  }
}
