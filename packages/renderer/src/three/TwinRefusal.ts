/** Thrown by a kind's patch: the material's shader has no place for it. three draws the material then. */
export class TwinRefusal extends Error {}
