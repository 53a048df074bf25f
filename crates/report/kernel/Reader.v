(* Numbers in text. A line is a row, commas stand between its cells; a cell is empty or a number: digits with a sign, a
   point, an exponent, or a fraction of two whole numbers. *)
From Coq Require Import Init.Byte ZArith QArith List.
Import ListNotations.

(* Bytes, eight at a time as far as they go: Coq reads such a literal in two thirds of the time. *)
Inductive text := End | Char (c : byte) (rest : text) | Chars (a b c d e f g h : byte) (rest : text).
Fixpoint text_of_bytes (l : list byte) :=
  match l with
  | a :: b :: c :: d :: e :: f :: g :: h :: l => Chars a b c d e f g h (text_of_bytes l)
  | c :: l => Char c (text_of_bytes l)
  | [] => End
  end.
Fixpoint bytes_of_text t :=
  match t with
  | End => []
  | Char c t => c :: bytes_of_text t
  | Chars a b c d e f g h t => a :: b :: c :: d :: e :: f :: g :: h :: bytes_of_text t
  end.
Declare Scope text_scope.
Delimit Scope text_scope with text.
String Notation text text_of_bytes bytes_of_text : text_scope.

Definition digit (c : byte) : option Z :=
  match c with
  | x30 => Some 0%Z | x31 => Some 1%Z | x32 => Some 2%Z | x33 => Some 3%Z | x34 => Some 4%Z
  | x35 => Some 5%Z | x36 => Some 6%Z | x37 => Some 7%Z | x38 => Some 8%Z | x39 => Some 9%Z
  | _ => None
  end.

(* What has been read of a cell. [Sign], [Point], [Slash] and [Power] still want a digit. *)
Inductive progress :=
  | Nothing | Sign (s : Z) | Whole (s n : Z) | Point (s n : Z) (any : bool) | Part (s n : Z) (d : positive)
  | Slash (s n : Z) | Ratio (s n d : Z) | Power (s n : Z) (d : positive) (t : option Z) | Raised (s n : Z) (d : positive) (t e : Z)
  | Wrong.

Definition next (p : progress) (c : byte) : progress :=
  match digit c, p with
  | Some k, Nothing => Whole 1 k
  | Some k, Sign s => Whole s k
  | Some k, Whole s n => Whole s (10 * n + k)
  | Some k, Point s n _ => Part s (10 * n + k) 10
  | Some k, Part s n d => Part s (10 * n + k) (10 * d)
  | Some k, Slash s n => Ratio s n k
  | Some k, Ratio s n d => Ratio s n (10 * d + k)
  | Some k, Power s n d t => Raised s n d (match t with Some t => t | None => 1 end) k
  | Some k, Raised s n d t e => Raised s n d t (10 * e + k)
  | None, _ =>
    match c, p with
    | x2b, Nothing => Sign 1            (* + *)
    | x2d, Nothing => Sign (-1)         (* - *)
    | x2e, Nothing => Point 1 0 false   (* . *)
    | x2e, Sign s => Point s 0 false
    | x2e, Whole s n => Point s n true
    | x2f, Whole s n => Slash s n       (* / *)
    | x65, Whole s n | x45, Whole s n | x65, Point s n true | x45, Point s n true => Power s n 1 None   (* e, E *)
    | x65, Part s n d | x45, Part s n d => Power s n d None
    | x2b, Power s n d None => Power s n d (Some 1%Z)
    | x2d, Power s n d None => Power s n d (Some (-1)%Z)
    | _, _ => Wrong
    end
  | _, Wrong => Wrong
  end%Z.

(* [None]: no number. [Some None]: an empty cell. *)
Definition finish (p : progress) : option (option Q) :=
  match p with
  | Nothing => Some None
  | Whole s n | Point s n true => Some (Some (s * n # 1))
  | Part s n d => Some (Some (s * n # d))
  | Ratio s n (Zpos d) => Some (Some (s * n # d))
  | Raised s n d 1 e => Some (Some (s * n * 10 ^ e # d))
  | Raised s n d _ e => Some (Some (s * n # d * Z.to_pos (10 ^ e)))
  | _ => None
  end.

Definition row := list (option Q).

Fixpoint scan (t : list byte) (p : progress) (cells : row) (rows : list row) : option (list row) :=
  match t with
  | [] => match p, cells with Nothing, [] => Some rows | _, _ => None end
  | x2c :: t => match finish p with Some v => scan t Nothing (v :: cells) rows | None => None end
  | x0a :: t => match finish p with Some v => scan t Nothing [] (rev' (v :: cells) :: rows) | None => None end
  | c :: t => scan t (next p c) cells rows
  end.

(* The rows of pieces of text, each of which ends with the end of a line; none at all if a cell is no number. *)
Fixpoint gather (pieces : list text) (rows : list row) : option (list row) :=
  match pieces with
  | [] => Some rows
  | t :: pieces => match scan (bytes_of_text t) Nothing [] rows with Some rows => gather pieces rows | None => None end
  end.
Definition read (pieces : list text) : list row := match gather pieces [] with Some rows => rev' rows | None => [] end.

(* What stands in a column, from 0; the number there, or 0. *)
Definition entry (column : nat) (r : row) : option Q := nth column r None.
Definition number (column : nat) (r : row) : Q := match entry column r with Some q => q | None => 0 end.
Definition point (r : row) : Q * Q := (number 0 r, number 1 r).
