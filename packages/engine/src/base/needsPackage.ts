/**
 * Code that imports a package which a host of the engine need not have installed.
 * @param use - what needs it, with the verb, for the message: 'Scripts need'
 * @throws Error (as a rejection) that names the package and the mend, when the code cannot be loaded
 */
export function needsPackage<Code>(name: string, use: string, code: Promise<Code>): Promise<Code> {
  return code.catch((cause: unknown) => {
    throw new Error(
      `${use} the package ${name}, which cannot be loaded; install it (npm install ${name}), or serve its files with the page.`,
      { cause },
    );
  });
}
