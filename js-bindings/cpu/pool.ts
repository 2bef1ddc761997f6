/** Lends an object that is used again and again, so that a call need not make one. A call inside of another gets its own. */
export class Pool<Item> {
  private spare: Item | undefined

  constructor(private readonly make: () => Item) {}

  take(): Item {
    const item = this.spare ?? this.make()
    this.spare = undefined
    return item
  }

  giveBack(item: Item) {
    this.spare = item
  }
}
