/** Thrown by a kind's patch if the material's shader has no place for it; three then draws the material. */
export class TwinRefusal extends Error {}
