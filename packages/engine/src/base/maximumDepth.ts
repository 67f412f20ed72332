/** Objects from the top of a scene to the deepest: three goes through them by recursion, and bears some 2,500. */
export const maximumDepth = 500;
